// SPDX-License-Identifier: MIT
#include "isa/registry.hpp"

#define BOOST_DLL_USE_STD_FS
#include "isa/nearest_name.hpp"
#include "isa/plugin.hpp"

#include <algorithm>
#include <stdexcept>
#include <system_error>

#include <boost/dll/shared_library.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rasterloom::isa {

struct IsaRegistry::Library {
    std::filesystem::path path;
    boost::dll::shared_library object;
    const Isa* isa = nullptr;
};

namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, std::string_view what) {
    throw std::runtime_error(fmt::format("{}: {}", path.string(), what));
}

boost::dll::shared_library open(const std::filesystem::path& path) {
    std::error_code failed;
    if (!std::filesystem::is_regular_file(path, failed)) {
        refuse(path, "there is no such file; a shared object with an instruction set is expected");
    }
    boost::dll::shared_library object;
    object.load(path, failed, boost::dll::load_mode::rtld_local);
    if (failed) {
        refuse(path, fmt::format("cannot be loaded as a shared object ({})", failed.message()));
    }
    return object;
}

const Isa* isa_of(const std::filesystem::path& path, const boost::dll::shared_library& object) {
    if (!object.has(kPluginSymbol)) {
        refuse(path, fmt::format("is no instruction set: it does not export {}", kPluginSymbol));
    }
    const Plugin* plugin = object.get<PluginFunction>(kPluginSymbol)();
    if (plugin == nullptr) {
        refuse(path, fmt::format("{} returned nothing", kPluginSymbol));
    }
    if (plugin->version != kPluginVersion) {
        refuse(path, fmt::format(
                         "was built for version {} of the plug-in contract, version {} is expected",
                         plugin->version, kPluginVersion));
    }
    if (plugin->isa == nullptr) {
        refuse(path, fmt::format("{} names no instruction set", kPluginSymbol));
    }
    return plugin->isa;
}

}  // namespace

IsaRegistry::IsaRegistry() = default;
IsaRegistry::~IsaRegistry() = default;
IsaRegistry::IsaRegistry(IsaRegistry&&) noexcept = default;
IsaRegistry& IsaRegistry::operator=(IsaRegistry&&) noexcept = default;

void IsaRegistry::add(const Isa& isa) {
    const bool taken = std::any_of(isas_.begin(), isas_.end(),
                                   [&](const Isa* known) { return known->name() == isa.name(); });
    if (taken) {
        throw std::invalid_argument(
            fmt::format("there is an instruction set '{}' already", isa.name()));
    }
    isas_.push_back(&isa);
}

const Isa& IsaRegistry::load(const std::filesystem::path& path) {
    std::error_code ignored;
    const std::filesystem::path absolute =
        std::filesystem::absolute(path, ignored).lexically_normal();
    for (const auto& library : libraries_) {
        if (library->path == absolute) {
            return *library->isa;
        }
    }
    auto library = std::make_unique<Library>();
    library->path = absolute;
    library->object = open(absolute);
    library->isa = isa_of(absolute, library->object);
    try {
        add(*library->isa);
    } catch (const std::invalid_argument& error) {
        refuse(absolute, error.what());
    }
    libraries_.push_back(std::move(library));
    return *libraries_.back()->isa;
}

const Isa& IsaRegistry::find(std::string_view name) const {
    std::vector<std::string_view> names;
    for (const Isa* isa : isas_) {
        if (isa->name() == name) {
            return *isa;
        }
        names.push_back(isa->name());
    }
    throw std::invalid_argument(fmt::format("there is no instruction set '{}'; known: {}{}", name,
                                            fmt::join(names, ", "), did_you_mean(name, names)));
}

}  // namespace rasterloom::isa
