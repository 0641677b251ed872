// SPDX-License-Identifier: MIT
// Simulated annealing of the polygons' places and shapes.
#pragma once

#include "appendix_c.hpp"
#include "drawing.hpp"

#include <array>
#include <cstdint>
#include <random>
#include <vector>

// A polygon whose numbers of corners and lines are given.
struct Piece {
    int corners = 0, lines = 0;
    Outline outline;
    std::vector<Row> rows;
};

class Search {
  public:
    explicit Search(std::uint64_t seed);
    void anneal(long steps);
    // How many entries of each histogram are wrong, to standard error.
    void report() const;

    const std::vector<Piece>& pieces() const { return pieces_; }

  private:
    int below(int bound) { return static_cast<int>(random_() % static_cast<unsigned>(bound)); }
    bool accepts(double growth);

    void prepare_cells();
    void take_off_apron();
    double cover(int x, int y, int times);
    double put(const Piece& piece, int times);
    double put_in(Processor& processor, const Piece& piece, int times);
    bool make_afresh(Piece& piece);
    bool try_afresh(Piece& piece);
    bool vary(Piece& piece);
    void change_one();
    void exchange_corners();

    std::mt19937_64 random_;
    double heat_ = 0;
    std::vector<Processor> processors_ = appendix_c();
    Target empty_{8, 1, 1, ""};                        // cells of the drawing without any polygon
    std::vector<Corner> cells_;                        // of the drawing
    std::array<int, kCells> ground_{};                 // layers below the shuttle
    std::array<int, kCells> layers_{};                 // of the shuttle
    std::array<std::vector<Target*>, kCells> depths_;  // of the processors that have the cell
    std::vector<Piece> pieces_;
};
