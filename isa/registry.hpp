// SPDX-License-Identifier: MIT
// The instruction sets a run knows: the built-in ones, added by name, and those loaded from shared
// objects.
#pragma once

#include "isa/isa.hpp"

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

namespace rasterloom::isa {

class IsaRegistry {
  public:
    IsaRegistry();
    ~IsaRegistry();
    IsaRegistry(IsaRegistry&&) noexcept;
    IsaRegistry& operator=(IsaRegistry&&) noexcept;

    // `isa` must outlive the registry. Throws std::invalid_argument when the name is taken.
    void add(const Isa& isa);

    // Loads a plug-in (isa/plugin.hpp); cores and programs it makes must not outlive the registry.
    // A file loaded before gives the same ISA. Throws std::runtime_error naming the file and what
    // was expected.
    const Isa& load(const std::filesystem::path& path);

    // Throws std::invalid_argument naming the valid names when there is none of this name.
    const Isa& find(std::string_view name) const;

    const std::vector<const Isa*>& all() const { return isas_; }

  private:
    struct Library;
    std::vector<std::unique_ptr<Library>> libraries_;
    std::vector<const Isa*> isas_;
};

}  // namespace rasterloom::isa
