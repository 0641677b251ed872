// SPDX-License-Identifier: MIT
// Searches for the 245 small polygons of the runway scene (machine/host/scene_runway.cpp):
// simulated annealing of their places and shapes within a drawn outline, until the histograms of
// Parks 1982, appendix C, come out; then of their greys and layers, until the drawing does. Prints
// the table:
//
//     c++ -std=c++20 -O2 -o fit scripts/fit_runway/*.cpp
//     ./fit 1 300000000 > table.cpp        (seed, steps: some 3 microseconds each)
//
// What is left of the histograms goes to standard error: how many of a processor's segment lengths,
// heights, depth complexity and corners are wrong. 40 million steps get the uniprocessor right, or
// nearly so; scene_runway_table.cpp comes from 288 million of the program from which this one has
// been tidied up, so no seed gives exactly that table.
#include "painting.hpp"
#include "search.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <utility>
#include <vector>

namespace {

// From the nose to the tail, as a data base of the shuttle's parts would have them.
void sort_by_place(std::vector<Piece>& pieces) {
    std::ranges::stable_sort(pieces, {}, [](const Piece& piece) {
        int x = 0, y = 0;
        for (const auto& corner : piece.outline) {
            x += corner.x;
            y += corner.y;
        }
        return std::pair(x / piece.corners / 6, y / piece.corners);
    });
}

void print_table(std::span<const Piece> pieces, const Painting& painting) {
    std::puts(
        "// SPDX-License-Identifier: MIT\n"
        "// Found by scripts/fit_runway/; not meant to be edited.\n"
        "#include \"machine/host/scene_runway_table.hpp\"\n\n"
        "namespace rasterloom::host {\nnamespace {\n");
    std::printf("constexpr std::array<TinyPolygon, %zu> kShuttle{{\n", pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        std::printf("    {%d, %zu, %d, {{", painting.grey(i), painting.layer(i), pieces[i].corners);
        const char* before = "";
        for (const auto& corner : pieces[i].outline) {
            std::printf("%s{%d, %d}", before, corner.x - kLeft, corner.y - kBottom);
            before = ", ";
        }
        std::puts("}}},");
    }
    std::puts(
        "}};\n\n}  // namespace\n\n"
        "std::span<const TinyPolygon> runway_shuttle() {\n    return kShuttle;\n}\n\n"
        "}  // namespace rasterloom::host");
}

}  // namespace

int main(int count, char** arguments) {
    const auto seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const long steps = count > 2 ? std::strtol(arguments[2], nullptr, 10) : 300'000'000;
    Search search(seed);
    search.anneal(steps);
    search.report();
    auto pieces = search.pieces();
    sort_by_place(pieces);
    Painting painting(pieces, seed);
    painting.anneal(3'000'000);
    print_table(pieces, painting);
}
