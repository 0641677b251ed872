// SPDX-License-Identifier: MIT
#include "machine/config/array_fields.hpp"

#include "machine/config/field_builders.hpp"

namespace rasterloom::config {

void add_array_fields(std::vector<Field>& fields) {
    fields.push_back(yes_no_field(
        "array.line_locked",
        "whether the program counter of a lock-step array goes back to 0 with each scanline of its "
        "video output",
        [](auto& machine) -> auto& { return machine.array.line_locked; }));
    fields.push_back(count_field(
        "array.line", "cycles of a scanline", 1, 1'000'000,
        [](auto& machine) -> auto& { return machine.array.line; }));
    fields.push_back(count_field(
        "array.lines", "scanlines of a picture", 1, 65535,
        [](auto& machine) -> auto& { return machine.array.lines; }));
    fields.push_back(count_field(
        "array.visible_lines", "the first of them, which show something; at most all", 1, 4096,
        [](auto& machine) -> auto& { return machine.array.visible_lines; }));
}

}  // namespace rasterloom::config
