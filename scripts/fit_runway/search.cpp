// SPDX-License-Identifier: MIT
#include "search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

Search::Search(std::uint64_t seed) : random_(seed) {
    prepare_cells();
    take_off_apron();
    for (const auto& kind : kKinds)
        for (int i = 0; i < kind.number; ++i) {
            Piece piece{kind.corners, kind.lines, {}, {}};
            while (!make_afresh(piece)) {
            }
            put(piece, 1);
            pieces_.push_back(piece);
        }
}

void Search::anneal(long steps) {
    constexpr double kHot = 4, kCold = 0.12;
    for (long step = 0; step < steps; ++step) {
        heat_ =
            kHot * std::pow(kCold / kHot, static_cast<double>(step) / static_cast<double>(steps));
        if (step % 24 == 0)
            exchange_corners();
        else
            change_one();
    }
}

void Search::report() const {
    for (const auto& p : processors_)
        std::fprintf(stderr, "%-14s lengths %d heights %d depth %d corners %d\n", p.name,
                     p.lengths.wrong(), p.heights.wrong(), p.depth.wrong(), p.corners.wrong());
    std::fprintf(stderr, "empty cells %d\n", empty_.wrong());
}

bool Search::accepts(double growth) {
    return growth <= 0 ||
           static_cast<double>(random_() >> 11) * 0x1.0p-53 < std::exp(-growth / heat_);
}

void Search::prepare_cells() {
    ground_.fill(1);
    for (const auto& row : rows_of(kApron))
        for (int x = std::max(row.left, kLeft); x <= row.right && x < kLeft + kColumns; ++x)
            if (row.y >= kBottom && row.y < kBottom + kLines)
                ground_[static_cast<std::size_t>(cell_of(x, row.y))] = 2;
    for (int cell = 0; cell < kCells; ++cell) {
        if (drawn_at(cell) == '.')
            continue;
        const Corner place{kLeft + cell % kColumns, kBottom + cell / kColumns};
        cells_.push_back(place);
        empty_.add(1, 1);
        for (auto& processor : processors_)
            if (processor.has(place.x, place.y)) {
                processor.depth.add(ground_[static_cast<std::size_t>(cell)], 1);
                depths_[static_cast<std::size_t>(cell)].push_back(&processor.depth);
            }
    }
}

void Search::take_off_apron() {
    for (auto& processor : processors_)
        for (const auto& row : rows_of(kApron))
            if (processor.reaches(row) && processor.has_line(row.y))
                processor.lengths.discount(processor.columns(row));
}

double Search::cover(int x, int y, int times) {
    const auto cell = static_cast<std::size_t>(cell_of(x, y));
    const int before = ground_[cell] + layers_[cell];
    double growth = empty_.add(layers_[cell] == 0 ? 1 : 0, -1);
    layers_[cell] += times;
    growth += empty_.add(layers_[cell] == 0 ? 1 : 0, 1);
    for (auto* depth : depths_[cell])
        growth += depth->add(before, -1) + depth->add(before + times, 1);
    return growth;
}

// Adds the piece (times = 1) or takes it off (-1); returns by how much the error grows.
double Search::put(const Piece& piece, int times) {
    double growth = 0;
    for (const auto& row : piece.rows)
        for (int x = row.left; x <= row.right; ++x)
            growth += cover(x, row.y, times);
    for (auto& processor : processors_)
        growth += put_in(processor, piece, times);
    return growth;
}

double Search::put_in(Processor& processor, const Piece& piece, int times) {
    double growth = 0;
    int lines = 0;
    bool is_reached = false;
    Outline part;
    for (const auto& row : piece.rows) {
        if (!processor.reaches(row))
            continue;
        is_reached = true;
        if (row.y == processor.top)
            part.insert(part.end(), {{row.left, row.y}, {row.right, row.y}});
        if (!processor.has_line(row.y))
            continue;
        ++lines;
        growth += processor.lengths.add(processor.columns(row), times);
    }
    if (!is_reached && processor.top < 511)
        return growth;
    growth += processor.heights.add(lines, times);
    for (const auto& corner : piece.outline)
        if (corner.y <= processor.top)
            part.push_back(corner);
    std::ranges::sort(part);
    const auto end = std::unique(part.begin(), part.end());
    return growth + processor.corners.add(static_cast<int>(end - part.begin()), times);
}

// A new outline of the piece's corners and lines somewhere in the drawing.
bool Search::make_afresh(Piece& piece) {
    constexpr int kTries = 40;
    for (int i = 0; i < kTries; ++i)
        if (try_afresh(piece))
            return true;
    return false;
}

bool Search::try_afresh(Piece& piece) {
    const Corner place = cells_[static_cast<std::size_t>(below(static_cast<int>(cells_.size())))];
    const int top = place.y + below(piece.lines);
    const int width = piece.lines >= 11 ? 4 : (below(4) == 0 ? 14 : 5);
    Outline outline;
    for (int i = 0; i < piece.corners; ++i)
        outline.push_back({place.x - width / 2 + below(width + 1), top - below(piece.lines)});
    if (piece.corners > 1) {
        outline[0].y = top;
        outline[1].y = top - piece.lines + 1;
    }
    double x = 0, y = 0;
    for (const auto& corner : outline) {
        x += static_cast<double>(corner.x) / piece.corners;
        y += static_cast<double>(corner.y) / piece.corners;
    }
    std::ranges::sort(outline, {},
                      [&](const Corner& corner) { return std::atan2(corner.y - y, corner.x - x); });
    if (!is_strictly_convex(outline))
        return false;
    auto rows = rows_of(outline);
    if (!is_in_drawing(rows))
        return false;
    piece.outline = std::move(outline);
    piece.rows = std::move(rows);
    return true;
}

// The same polygon elsewhere, or with one corner elsewhere.
bool Search::vary(Piece& piece) {
    if (below(7) < 3) {
        const int dx = below(4) == 0 ? below(25) - 12 : below(5) - 2;
        const int dy = below(5) - 2;
        for (auto& corner : piece.outline)
            corner = {corner.x + dx, corner.y + dy};
    } else {
        auto& corner = piece.outline[static_cast<std::size_t>(below(piece.corners))];
        corner.x += below(4) == 0 ? below(9) - 4 : below(3) - 1;
        corner.y += below(2) == 0 ? below(3) - 1 : 0;
        if (!is_strictly_convex(piece.outline))
            return false;
    }
    piece.rows = rows_of(piece.outline);
    return static_cast<int>(piece.rows.size()) == piece.lines && is_in_drawing(piece.rows);
}

void Search::change_one() {
    auto& piece = pieces_[static_cast<std::size_t>(below(static_cast<int>(pieces_.size())))];
    Piece changed = piece;
    if (!(below(10) < 3 ? make_afresh(changed) : vary(changed)))
        return;
    const double growth = put(piece, -1) + put(changed, 1);
    if (accepts(growth)) {
        piece = std::move(changed);
    } else {
        put(changed, -1);
        put(piece, 1);
    }
}

// One polygon of another's number of corners, and the other way round.
void Search::exchange_corners() {
    const int count = static_cast<int>(pieces_.size());
    auto& a = pieces_[static_cast<std::size_t>(below(count))];
    auto& b = pieces_[static_cast<std::size_t>(below(count))];
    if (a.corners == b.corners || std::min(a.corners, b.corners) < 2 ||
        std::min(a.lines, b.lines) < 2)
        return;
    Piece new_a{b.corners, a.lines, {}, {}};
    Piece new_b{a.corners, b.lines, {}, {}};
    if (!make_afresh(new_a) || !make_afresh(new_b))
        return;
    const double growth = put(a, -1) + put(b, -1) + put(new_a, 1) + put(new_b, 1);
    if (accepts(growth)) {
        a = std::move(new_a);
        b = std::move(new_b);
    } else {
        put(new_a, -1);
        put(new_b, -1);
        put(a, 1);
        put(b, 1);
    }
}
