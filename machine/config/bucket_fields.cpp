// SPDX-License-Identifier: MIT
#include "machine/config/bucket_fields.hpp"

#include "machine/config/field_builders.hpp"

namespace rasterloom::config {

namespace {

constexpr std::int64_t kMostCycles = 1'000'000;
constexpr std::int64_t kMostPlaces = 1'000'000'000;

void add_sorter_fields(std::vector<Field>& fields) {
    fields.push_back(choice_field<host::OverlapRule>(
        "sorter.rule",
        "which tiles a triangle belongs to: those that its bounding box meets, those that it meets "
        "itself, or those in which it covers a pixel",
        {{"bounding_box", host::OverlapRule::bounding_box},
         {"exact", host::OverlapRule::exact},
         {"covered", host::OverlapRule::covered}},
        [](auto& m) -> auto& { return m.sorter.rule; }));
    fields.push_back(choice_field<TileAssignment>(
        "sorter.assignment",
        "which rasterizer draws a tile: its owner, by turns or by blocks of the screen; or one "
        "that "
        "is free, the next tile or the largest first",
        {{"interleaved", TileAssignment::interleaved},
         {"blocks", TileAssignment::blocks},
         {"next_free", TileAssignment::next_free},
         {"largest_first", TileAssignment::largest_first}},
        [](auto& m) -> auto& { return m.sorter.assignment; }));
    fields.push_back(choice_field<TileMeasure>(
        "sorter.largest_by",
        "what makes a tile large: its triangles, its pixels, or its time on a hardware rasterizer",
        {{"triangles", TileMeasure::triangles},
         {"pixels", TileMeasure::pixels},
         {"work", TileMeasure::work}},
        [](auto& m) -> auto& { return m.sorter.largest_by; }));
    fields.push_back(duration_field(
        "sorter.time_per_triangle", "the sorter's work on a triangle, before anything is drawn",
        [](auto& m) -> auto& { return m.sorter.time_per_triangle; }));
    fields.push_back(duration_field(
        "sorter.time_per_pair", "the same, for each tile that the triangle belongs to",
        [](auto& m) -> auto& { return m.sorter.time_per_pair; }));
    fields.push_back(duration_field(
        "sorter.time_per_word", "transfer time of a word to a software rasterizer",
        [](auto& m) -> auto& { return m.sorter.time_per_word; }));
}

}  // namespace

void add_bucket_fields(std::vector<Field>& fields) {
    add_sorter_fields(fields);
    fields.push_back(choice_field<RasterizerKind>(
        "rasterizer.kind",
        "a triangle unit and a pixel unit in a pipeline, or a processor that runs nodes.program",
        {{"hardware", RasterizerKind::hardware}, {"software", RasterizerKind::software}},
        [](auto& m) -> auto& { return m.rasterizer.kind; }));
    fields.push_back(count_field(
        "rasterizer.cycles_per_triangle", "the triangle unit's work, k", 0, kMostCycles,
        [](auto& m) -> auto& { return m.rasterizer.cycles_per_triangle; }));
    fields.push_back(count_field(
        "rasterizer.cycles_per_pixel", "the pixel unit's work", 0, kMostCycles,
        [](auto& m) -> auto& { return m.rasterizer.cycles_per_pixel; }));
    fields.push_back(optional_count_field(
        "rasterizer.fifo",
        "triangles between the triangle unit and the pixel unit, the one that is drawn included; "
        "0: the units take turns",
        "unlimited", 0, kMostPlaces, [](auto& m) -> auto& { return m.rasterizer.fifo; }));
    fields.push_back(count_field(
        "rasterizer.input_fifo", "tiles and triangles that wait at a software rasterizer", 1, 65535,
        [](auto& m) -> auto& { return m.rasterizer.input_fifo; }));
}

}  // namespace rasterloom::config
