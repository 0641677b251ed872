// SPDX-License-Identifier: MIT
// The results of a sweep in one SQLite file (docs/sweep.md has its tables). A point's row is there
// whole or not at all, whenever the process ends.
#pragma once

#include "machine/observe/database.hpp"
#include "machine/observe/sweep/sweep_row.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rasterloom::observe {

class SweepTable {
  public:
    struct Known {
        std::string fingerprint;
        bool failed = false;
    };

    enum class Start : std::uint8_t { go_on, anew };

    // Makes the file, or goes on with one that holds a sweep over the same parameters; anew: takes
    // out whatever sweep it holds. Throws OutputError for any other file, which stays as it is.
    SweepTable(const std::filesystem::path& path, std::vector<std::string> parameters,
               Start start = Start::go_on);

    // The points that are there, by key.
    const std::map<std::string, Known>& known() const { return known_; }

    // All of them, or, when that fails, none. A row takes the place of one with its key.
    void add(std::span<const SweepRow> rows);

    // Table `points` in the order of keys, with a line of names.
    std::string csv() const;

  private:
    void open_or_make(Start start);
    void check_is_of_a_sweep() const;
    void check_columns() const;
    void make();
    void read_known();
    std::vector<std::string> columns() const;

    std::filesystem::path path_;
    std::vector<std::string> parameters_;
    Database database_;
    std::map<std::string, Known> known_;
};

}  // namespace rasterloom::observe
