// SPDX-License-Identifier: MIT
#include "machine/node/lockstep/kernels.hpp"

#include "machine/node/lockstep/highway_targets.hpp"
#include "machine/node/lockstep/kernel_tables.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <hwy/highway.h>

namespace rasterloom::lockstep {
namespace {

void join(std::array<Kernel, kKernelCodes>& all, bool masked) {
    const auto registers = register_kernels(masked);
    const auto memory = memory_kernels(masked);
    std::copy(memory.begin(), memory.end(),
              std::copy(registers.begin(), registers.end(), all.begin()));
}

struct Path {
    std::int64_t target;
    Kernels kernels;
};

Path path_of(std::int64_t target) {
    hwy::GetChosenTarget().Update(target);
    Path path;
    path.target = target;
    join(path.kernels.full, false);
    join(path.kernels.masked, true);
    return path;
}

Path& current() {
    static Path path = path_of(hwy::SupportedAndGeneratedTargets().front());
    return path;
}

}  // namespace

const Kernels& kernels() {
    return current().kernels;
}

std::vector<std::string> kernel_paths() {
    std::vector<std::string> names{hwy::TargetName(current().target)};
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        if (target != current().target) {
            names.emplace_back(hwy::TargetName(target));
        }
    }
    return names;
}

void use_kernel_path(std::string_view name) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        if (name == hwy::TargetName(target)) {
            current() = path_of(target);
            return;
        }
    }
    throw std::invalid_argument(fmt::format("this host has no vector instructions \"{}\", but {}",
                                            name, fmt::join(kernel_paths(), ", ")));
}

}  // namespace rasterloom::lockstep
