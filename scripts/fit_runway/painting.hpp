// SPDX-License-Identifier: MIT
// Simulated annealing of the polygons' greys and layers.
#pragma once

#include "drawing.hpp"
#include "search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <random>
#include <span>
#include <utility>
#include <vector>

// Greys and layers so that what is on top is what was drawn.
class Painting {
  public:
    Painting(std::span<const Piece> pieces, std::uint64_t seed) : random_(seed), at_(kCells) {
        for (const auto& [letter, grey] : kGreys)
            palette_.push_back(grey);
        layers_.resize(pieces.size());
        std::iota(layers_.begin(), layers_.end(), std::size_t{0});
        greys_.assign(pieces.size(), palette_.back());
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            auto& cells = cells_.emplace_back();
            for (const auto& row : pieces[i].rows)
                for (int x = row.left; x <= row.right; ++x)
                    cells.push_back(static_cast<std::size_t>(cell_of(x, row.y)));
            for (const auto cell : cells)
                at_[cell].push_back(i);
        }
    }

    void anneal(long steps) {
        for (long step = 0; step < steps; ++step) {
            heat_ = 60 * std::pow(0.01, static_cast<double>(step) / static_cast<double>(steps));
            const auto i = random_() % greys_.size();
            if (random_() % 2 == 0)
                change(cells_[i], greys_[i], palette_[random_() % palette_.size()]);
            else
                exchange(i, random_() % greys_.size());
        }
    }

    int grey(std::size_t piece) const { return greys_[piece]; }
    std::size_t layer(std::size_t piece) const { return layers_[piece]; }

  private:
    double error(std::span<const std::size_t> cells) const {
        double sum = 0;
        for (const auto cell : cells) {
            const auto top = *std::ranges::max_element(
                at_[cell], {}, [&](std::size_t piece) { return layers_[piece]; });
            sum += std::abs(greys_[top] - kGreys.at(drawn_at(static_cast<int>(cell))));
        }
        return sum;
    }
    bool accepts(double growth) {
        return growth <= 0 ||
               static_cast<double>(random_() >> 11) * 0x1.0p-53 < std::exp(-growth / heat_);
    }
    void change(std::span<const std::size_t> cells, int& grey, int changed) {
        const double before = error(cells);
        std::swap(grey, changed);
        if (!accepts(error(cells) - before))
            std::swap(grey, changed);
    }
    void exchange(std::size_t a, std::size_t b) {
        auto cells = cells_[a];
        cells.insert(cells.end(), cells_[b].begin(), cells_[b].end());
        std::ranges::sort(cells);
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
        const double before = error(cells);
        std::swap(layers_[a], layers_[b]);
        if (!accepts(error(cells) - before))
            std::swap(layers_[a], layers_[b]);
    }

    std::mt19937_64 random_;
    double heat_ = 0;
    std::vector<int> palette_, greys_;
    std::vector<std::size_t> layers_;
    std::vector<std::vector<std::size_t>> at_;     // [cell]: pieces
    std::vector<std::vector<std::size_t>> cells_;  // [piece]
};
