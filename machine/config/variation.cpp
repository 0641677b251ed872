// SPDX-License-Identifier: MIT
#include "machine/config/variation.hpp"

#include "machine/config/error.hpp"
#include "machine/config/field.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::config {

namespace {

// mantissa / 10^decimals
struct Decimal {
    std::int64_t mantissa = 0;
    std::size_t decimals = 0;
};

constexpr std::size_t kMostDigits = 9;  // so that a product fits

// The decimal number at the beginning of `text`, which is cut off it.
Decimal take_decimal(std::string_view& text) {
    Decimal number;
    std::size_t digits = 0;
    bool fraction = false;
    while (!text.empty() && (std::isdigit(static_cast<unsigned char>(text[0])) != 0 ||
                             (text[0] == '.' && !fraction))) {
        if (text[0] == '.') {
            fraction = true;
        } else {
            number.mantissa = 10 * number.mantissa + (text[0] - '0');
            number.decimals += fraction ? 1 : 0;
            if (++digits > kMostDigits) {
                throw std::invalid_argument("too many digits");
            }
        }
        text.remove_prefix(1);
    }
    if (digits == 0) {
        throw std::invalid_argument("no number");
    }
    return number;
}

std::string to_text(Decimal number) {
    std::int64_t one = 1;
    for (; number.decimals > 0 && number.mantissa % 10 == 0; --number.decimals) {
        number.mantissa /= 10;
    }
    for (std::size_t i = 0; i < number.decimals; ++i) {
        one *= 10;
    }
    return number.decimals == 0 ? std::to_string(number.mantissa)
                                : fmt::format("{}.{:0{}}", number.mantissa / one,
                                              number.mantissa % one, number.decimals);
}

const Field& field_of(const std::string& key, const std::vector<Field>& fields,
                      const Position& where) {
    const auto found = std::find_if(fields.begin(), fields.end(),
                                    [&](const Field& field) { return field.path == key; });
    if (found != fields.end()) {
        return *found;
    }
    std::vector<std::string> names;
    for (const Field& field : fields) {
        names.push_back(field.path);
    }
    refuse(where, {}, key, "unknown key", "a key of docs/configuration.md",
           nearest_name(key, names));
}

std::string scaled(const Field& field, const std::string& change, const MachineDescription& base,
                   const Position& where) {
    const std::string now = field.write(base);
    try {
        const std::string value = scale_value(now, std::string_view(change).substr(1));
        if (value.find_first_of("123456789") == std::string::npos && now != value) {
            throw std::invalid_argument("not above zero");
        }
        return value;
    } catch (const std::invalid_argument& problem) {
        refuse(where, field.path, change,
               fmt::format("{}, applied to {}", problem.what(), now.empty() ? "nothing" : now),
               "a factor above zero such as x0.5 for a key that holds a number, or a value");
    }
}

}  // namespace

std::string scale_value(std::string_view value, std::string_view factor) {
    const Decimal number = take_decimal(value);
    const Decimal by = take_decimal(factor);
    if (!factor.empty()) {
        throw std::invalid_argument("no factor");
    }
    return to_text({number.mantissa * by.mantissa, number.decimals + by.decimals}) +
           std::string(value);
}

std::vector<Variation> parse_variations(std::string_view text, const MachineDescription& base) {
    const Position where{"--vary", 0, 0};
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == text.size()) {
        refuse(where, {}, text, "no key and values", "KEY=x0.5,x2 or KEY=VALUE,VALUE");
    }
    const std::vector<Field> fields = machine_fields();
    const std::string key(text.substr(0, equals));
    const Field& field = field_of(key, fields, where);
    std::vector<Variation> variations;
    std::string_view rest = text.substr(equals + 1);
    while (true) {
        const std::size_t comma = rest.find(',');
        const std::string change(rest.substr(0, comma));
        const bool is_factor = change.size() > 1 && change[0] == 'x';
        const std::string value = is_factor ? scaled(field, change, base, where) : change;
        variations.push_back(
            {key, change, value, make_override(key, value, "--vary " + key + "=" + change)});
        if (comma == std::string_view::npos) {
            return variations;
        }
        rest.remove_prefix(comma + 1);
    }
}

}  // namespace rasterloom::config
