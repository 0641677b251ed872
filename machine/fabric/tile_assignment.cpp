// SPDX-License-Identifier: MIT
#include "machine/fabric/tile_assignment.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom {

namespace {

std::size_t square_root(std::size_t n) {
    std::size_t root = 1;
    while ((root + 1) * (root + 1) <= n) {
        ++root;
    }
    return root;
}

// The greatest divisor of `n` that is no more than its square root.
std::size_t lesser_side(std::size_t n) {
    std::size_t side = square_root(n);
    while (n % side != 0) {
        --side;
    }
    return side;
}

void require_positive(int number, const char* what) {
    if (number < 1) {
        throw std::invalid_argument(
            fmt::format("a tile sorter has at least 1 {}, not {}", what, number));
    }
}

}  // namespace

bool is_static(TileAssignment assignment) {
    return assignment == TileAssignment::interleaved || assignment == TileAssignment::blocks;
}

std::vector<std::size_t> owners_of_tiles(TileAssignment assignment, int columns, int rows,
                                         int rasterizers) {
    const auto width = static_cast<std::size_t>(columns);
    const auto height = static_cast<std::size_t>(rows);
    const auto count = static_cast<std::size_t>(rasterizers);
    const std::size_t shift = square_root(count);
    const std::size_t down = lesser_side(count);
    const std::size_t across = count / down;
    std::vector<std::size_t> owners;
    owners.reserve(width * height);
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            owners.push_back(assignment == TileAssignment::interleaved
                                 ? (x + shift * y) % count
                                 : x * across / width + across * (y * down / height));
        }
    }
    return owners;
}

TileQueues::TileQueues(const TileQueueSettings& settings)
    : settings_(settings), static_(is_static(settings.assignment)) {
    require_positive(settings.columns, "column of tiles");
    require_positive(settings.rows, "row of tiles");
    require_positive(settings.rasterizers, "rasterizer");
    if (static_) {
        owners_ = owners_of_tiles(settings.assignment, settings.columns, settings.rows,
                                  settings.rasterizers);
        queues_.resize(static_cast<std::size_t>(settings.rasterizers));
    } else {
        owners_.resize(static_cast<std::size_t>(settings.columns) *
                       static_cast<std::size_t>(settings.rows));
        queues_.resize(1);
    }
    order_.resize(owners_.size());
    std::iota(order_.begin(), order_.end(), TileIndex{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](TileIndex a, TileIndex b) { return owners_[a] < owners_[b]; });
}

void TileQueues::order_by_size(std::span<const TileWork> pairs) {
    std::vector<std::uint64_t> size(tiles());
    for (const TileWork& pair : pairs) {
        size[pair.tile] += std::max(std::uint64_t{settings_.pair_weight},
                                    std::uint64_t{settings_.pixel_weight} * pair.pixels);
    }
    std::iota(order_.begin(), order_.end(), TileIndex{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](TileIndex a, TileIndex b) { return size[a] > size[b]; });
}

// A counting sort.
void TileQueues::fill(std::span<const TileWork> pairs) {
    if (settings_.assignment == TileAssignment::largest_first) {
        order_by_size(pairs);
    }
    std::vector<std::size_t> place(tiles());
    for (const TileWork& pair : pairs) {
        ++place[pair.tile];
    }
    std::size_t begin = 0;
    for (const TileIndex tile : order_) {
        const std::size_t count = std::exchange(place[tile], begin);
        begin += count;
    }
    const std::vector<std::size_t> begins = place;
    sorted_.resize(pairs.size());
    for (const TileWork& pair : pairs) {
        sorted_[place[pair.tile]++] = pair;
    }
    add_grants(begins);
}

// `begins` says for each tile where its pairs begin in sorted_.
void TileQueues::add_grants(const std::vector<std::size_t>& begins) {
    grants_.clear();
    queues_.assign(queues_.size(), {});
    for (std::size_t i = 0; i < order_.size(); ++i) {
        const std::size_t begin = begins[order_[i]];
        const std::size_t end = i + 1 < order_.size() ? begins[order_[i + 1]] : sorted_.size();
        if (begin == end) {
            continue;
        }
        Queue& queue = queues_[owners_[order_[i]]];
        if (static_ && queue.first < queue.end) {
            grants_.back() = {grants_.back().data(), grants_.back().size() + (end - begin)};
            continue;
        }
        if (queue.first == queue.end) {
            queue.first = grants_.size();
        }
        grants_.emplace_back(sorted_.data() + begin, end - begin);
        queue.end = grants_.size();
    }
}

const TileGrant* TileQueues::take(std::size_t rasterizer) {
    Queue& queue = queue_of(rasterizer);
    return queue.first < queue.end ? &grants_[queue.first++] : nullptr;
}

}  // namespace rasterloom
