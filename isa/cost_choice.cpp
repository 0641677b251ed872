// SPDX-License-Identifier: MIT
#include "isa/cost_choice.hpp"

#include "isa/nearest_name.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rasterloom::isa {
namespace {

template <typename Item>
std::vector<std::string_view> names_of(std::span<const Item> items) {
    std::vector<std::string_view> names;
    for (const Item& item : items) {
        names.push_back(item.name);
    }
    return names;
}

std::size_t index_of(std::string_view name, const std::vector<std::string_view>& names,
                     std::string_view owner, std::string_view kind) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        throw std::invalid_argument(fmt::format("{} has no {} '{}'; it has {}{}", owner, kind, name,
                                                fmt::join(names, ", "), did_you_mean(name, names)));
    }
    return static_cast<std::size_t>(found - names.begin());
}

}  // namespace

ResolvedCosts resolve_costs(std::string_view isa_name, std::span<const CostModelInfo> models,
                            const CostChoice& choice) {
    ResolvedCosts resolved;
    if (!choice.model.empty()) {
        resolved.model = index_of(choice.model, names_of(models), isa_name, "cost model");
    }
    const CostModelInfo& model = models[resolved.model];
    for (const CostParameter& parameter : model.parameters) {
        resolved.values.push_back(parameter.value);
    }
    const auto names = names_of(std::span<const CostParameter>(model.parameters));
    for (const auto& [name, value] : choice.overrides) {
        const std::size_t index =
            index_of(name, names, fmt::format("cost model '{}'", model.name), "parameter");
        if (value < 0 || value > kHighestCost) {
            throw std::invalid_argument(
                fmt::format("cost parameter '{}' is {}; 0 to {} cycles are expected", name, value,
                            kHighestCost));
        }
        resolved.values[index] = value;
    }
    return resolved;
}

}  // namespace rasterloom::isa
