// SPDX-License-Identifier: MIT
// Makes rows of the table of keys, one function a type of value. `get` is a generic accessor,
// [](auto& machine) -> auto& { return machine.links.latency; }, that serves reading and writing.
#pragma once

#include "machine/config/field.hpp"
#include "machine/config/units.hpp"
#include "machine/config/yaml_text.hpp"

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::config {

// The text of a scalar; throws std::invalid_argument for anything else.
inline const std::string& scalar_text(const Value& value) {
    if (value.kind != Value::Kind::scalar) {
        throw std::invalid_argument(fmt::format("{} where a value belongs", kind_name(value.kind)));
    }
    return value.text;
}

template <typename Get>
Field duration_field(std::string path, std::string summary, Get get) {
    return {std::move(path),
            "a duration such as 300ns or 5us",
            std::move(summary),
            false,
            [get](MachineDescription& machine, const Value& value, const Locator&) {
                get(machine) = parse_duration(scalar_text(value));
            },
            [get](const MachineDescription& machine) { return format_duration(get(machine)); }};
}

// A whole number from `least` to `most`.
template <typename Get>
Field count_field(std::string path, std::string summary, std::int64_t least, std::int64_t most,
                  Get get) {
    return {std::move(path),
            fmt::format("a whole number from {} to {}", least, most),
            std::move(summary),
            false,
            [get, least, most](MachineDescription& machine, const Value& value, const Locator&) {
                const std::int64_t count = parse_count(scalar_text(value));
                if (count < least || count > most) {
                    throw std::invalid_argument("out of range");
                }
                get(machine) = count;
            },
            [get](const MachineDescription& machine) { return std::to_string(get(machine)); }};
}

// An optional whole number from `least` to `most`; `none` is how it is written when there is none.
template <typename Get>
Field optional_count_field(std::string path, std::string summary, std::string none,
                           std::int64_t least, std::int64_t most, Get get) {
    return {
        std::move(path),
        fmt::format("{} or a whole number from {} to {}", none, least, most),
        std::move(summary),
        false,
        [get, none, least, most](MachineDescription& machine, const Value& value, const Locator&) {
            get(machine).reset();
            if (const std::string& text = scalar_text(value); text != none) {
                const std::int64_t count = parse_count(text);
                if (count < least || count > most) {
                    throw std::invalid_argument("out of range");
                }
                get(machine) = count;
            }
        },
        [get, none](const MachineDescription& machine) {
            return get(machine) ? std::to_string(*get(machine)) : none;
        }};
}

// An optional file, looked for beside the configuration.
template <typename Get>
Field file_field(std::string path, std::string expected, std::string summary, Get get) {
    return {std::move(path),
            std::move(expected),
            std::move(summary),
            false,
            [get](MachineDescription& machine, const Value& value, const Locator& locator) {
                const std::string& name = scalar_text(value);
                const auto found = locator.find(name, value.where.source, {});
                if (!found) {
                    throw std::invalid_argument("no such file (looked in " +
                                                Locator::places(value.where.source, {}) + ")");
                }
                get(machine) = FileReference{name, *found};
            },
            [get](const MachineDescription& machine) {
                const auto& file = get(machine);
                return file ? yaml_scalar(file->path.string()) : std::string();
            }};
}

template <typename Get>
Field bytes_field(std::string path, std::string summary, std::int64_t least, std::int64_t most,
                  Get get) {
    return {
        std::move(path),
        fmt::format("a size from {} to {}, such as 56KiB", format_bytes(least), format_bytes(most)),
        std::move(summary),
        false,
        [get, least, most](MachineDescription& machine, const Value& value, const Locator&) {
            const std::int64_t bytes = parse_bytes(scalar_text(value));
            if (bytes < least || bytes > most) {
                throw std::invalid_argument("out of range");
            }
            get(machine) = bytes;
        },
        [get](const MachineDescription& machine) { return format_bytes(get(machine)); }};
}

template <typename Get>
Field real_field(std::string path, std::string summary, double least, double most, Get get) {
    return {std::move(path),
            fmt::format("a number from {} to {}", least, most),
            std::move(summary),
            false,
            [get, least, most](MachineDescription& machine, const Value& value, const Locator&) {
                const double number = parse_real(scalar_text(value));
                if (number < least || number > most) {
                    throw std::invalid_argument("out of range");
                }
                get(machine) = number;
            },
            [get](const MachineDescription& machine) { return format_real(get(machine)); }};
}

inline std::string vector_text(const std::optional<glm::dvec3>& v) {
    return v ? fmt::format("[{}, {}, {}]", v->x, v->y, v->z) : std::string();
}

// `get`: of a vector, or of one that may be missing.
template <typename Get>
Field vector_field(std::string path, std::string summary, bool may_be_zero, Get get) {
    return {std::move(path),
            may_be_zero ? "a list of three numbers [x, y, z]"
                        : "a list of three numbers [x, y, z], not all zero",
            std::move(summary),
            false,
            [get, may_be_zero](MachineDescription& machine, const Value& value, const Locator&) {
                if (value.kind != Value::Kind::sequence || value.items.size() != 3) {
                    throw std::invalid_argument("not a list of three");
                }
                const glm::dvec3 vector{parse_real(scalar_text(value.items[0])),
                                        parse_real(scalar_text(value.items[1])),
                                        parse_real(scalar_text(value.items[2]))};
                const double square =
                    vector.x * vector.x + vector.y * vector.y + vector.z * vector.z;
                if (!may_be_zero && !(square > 1e-12)) {
                    throw std::invalid_argument("no direction");
                }
                if (!(square < 1e12)) {
                    throw std::invalid_argument("too large");
                }
                get(machine) = vector;
            },
            [get](const MachineDescription& machine) { return vector_text(get(machine)); }};
}

// One of a few names; `T` is an enumeration or a string.
template <typename T, typename Get>
Field choice_field(std::string path, std::string summary,
                   std::vector<std::pair<std::string, T>> choices, Get get) {
    std::vector<std::string> names;
    for (const auto& [name, meaning] : choices) {
        names.push_back(name);
    }
    return {std::move(path),
            fmt::format("one of {}", fmt::join(names, ", ")),
            std::move(summary),
            false,
            [get, choices](MachineDescription& machine, const Value& value, const Locator&) {
                for (const auto& [name, meaning] : choices) {
                    if (name == scalar_text(value)) {
                        get(machine) = meaning;
                        return;
                    }
                }
                throw std::invalid_argument("no such choice");
            },
            [get, choices](const MachineDescription& machine) {
                for (const auto& [name, meaning] : choices) {
                    if (meaning == get(machine)) {
                        return name;
                    }
                }
                return std::string();
            }};
}

template <typename Get>
Field yes_no_field(std::string path, std::string summary, Get get) {
    return choice_field<bool>(std::move(path), std::move(summary),
                              {{"true", true}, {"false", false}}, get);
}

}  // namespace rasterloom::config
