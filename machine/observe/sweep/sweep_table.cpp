// SPDX-License-Identifier: MIT
#include "machine/observe/sweep/sweep_table.hpp"

#include "machine/observe/csv_text.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::observe {

namespace {

constexpr std::int64_t kApplication = 0x524c5377;  // "RLSw": PRAGMA application_id
constexpr std::array<const char*, 5> kLeading{"key", "config", "scene", "status", "error"};

std::int64_t number(const Database& database, const std::string& sql) {
    Statement statement = database.prepare(sql);
    return statement.step() ? statement.column<std::int64_t>(0) : 0;
}

void bind(Statement& statement, int parameter, const Cell& cell) {
    std::visit([&](const auto& value) { statement.bind(parameter, value); }, cell);
}

// Six decimals of a share or ratio; SQL has all of them.
std::string csv_cell(const Statement& row, int column, bool is_real) {
    if (row.is_null(column)) {
        return {};
    }
    return is_real ? fmt::format("{:.6f}", row.column<double>(column))
                   : csv_text(row.column<std::string>(column));
}

// Of a table's columns: those of the configurations, between a scene and how it went.
std::string names_of_parameters(const std::vector<std::string>& columns) {
    const auto first = std::find(columns.begin(), columns.end(), "scene");
    const auto last = std::find(first, columns.end(), "status");
    if (std::distance(first, last) < 2) {
        return "no parameter";
    }
    return fmt::format("{}", fmt::join(first + 1, last, ", "));
}

std::string placeholders(std::size_t count) {
    return fmt::format("{}", fmt::join(std::vector<const char*>(count, "?"), ", "));
}

}  // namespace

SweepTable::SweepTable(const std::filesystem::path& path, std::vector<std::string> parameters,
                       Start start)
    : path_(path),
      parameters_(std::move(parameters)),
      database_(Database::open(path, Database::Access::change)) {
    open_or_make(start);
    read_known();
}

void SweepTable::open_or_make(Start start) {
    const bool is_new = number(database_, "SELECT count(*) FROM sqlite_master") == 0 &&
                        number(database_, "PRAGMA application_id") == 0;
    if (!is_new) {
        check_is_of_a_sweep();
    }
    if (is_new || start == Start::anew) {
        make();
    } else {
        check_columns();
    }
}

void SweepTable::check_is_of_a_sweep() const {
    if (number(database_, "PRAGMA application_id") != kApplication) {
        throw OutputError(
            fmt::format("{}: is a database, but not a sweep's; expected one that "
                        "`rasterloom sweep` wrote, or no file",
                        path_.string()));
    }
    Statement check = database_.prepare("PRAGMA quick_check(1)");
    if (!check.step() || check.column<std::string>(0) != "ok") {
        throw OutputError(fmt::format("{}: is damaged, perhaps cut off", path_.string()));
    }
}

std::vector<std::string> SweepTable::columns() const {
    std::vector<std::string> names(kLeading.begin(), kLeading.begin() + 3);
    names.insert(names.end(), parameters_.begin(), parameters_.end());
    names.insert(names.end(), kLeading.begin() + 3, kLeading.end());
    for (const Figure& figure : run_figures()) {
        names.emplace_back(figure.name);
    }
    return names;
}

void SweepTable::make() {
    std::string text = "key TEXT PRIMARY KEY, config TEXT NOT NULL, scene TEXT";
    for (const std::string& name : parameters_) {
        // NUMERIC: plain numbers are numbers in SQL; values with a unit stay text.
        text += fmt::format(", {} NUMERIC NOT NULL", sql_name(name));
    }
    text += ", status TEXT NOT NULL CHECK(status IN ('done', 'failed')), error TEXT";
    for (const Figure& figure : run_figures()) {
        text += fmt::format(", {} {}", figure.name, figure.type);
    }
    Transaction transaction(database_);
    database_.execute(fmt::format("PRAGMA application_id = {}", kApplication));
    database_.execute("DROP TABLE IF EXISTS points; DROP TABLE IF EXISTS emulation");
    database_.execute(fmt::format("CREATE TABLE points({}) WITHOUT ROWID", text));
    // Apart from the points, because it is not the same from run to run.
    database_.execute(
        "CREATE TABLE emulation(key TEXT PRIMARY KEY, fingerprint TEXT NOT NULL, "
        "wall_seconds REAL, real_time_factor REAL) WITHOUT ROWID");
    transaction.commit();
}

void SweepTable::check_columns() const {
    Statement rows = database_.prepare("SELECT name FROM pragma_table_info('points')");
    std::vector<std::string> there;
    while (rows.step()) {
        there.push_back(rows.column<std::string>(0));
    }
    if (there == columns()) {
        return;
    }
    const std::string over = names_of_parameters(there);
    const std::string expected = names_of_parameters(columns());
    throw OutputError(fmt::format(
        "{}: {}; expected a sweep over {}, or --fresh to begin anew", path_.string(),
        over == expected ? "was written by another version" : "holds a sweep over " + over,
        expected));
}

void SweepTable::read_known() {
    Statement rows = database_.prepare(
        "SELECT key, fingerprint, status = 'failed' FROM points JOIN emulation USING(key)");
    while (rows.step()) {
        known_[rows.column<std::string>(0)] = {rows.column<std::string>(1),
                                               rows.column<std::int64_t>(2) != 0};
    }
}

void SweepTable::add(std::span<const SweepRow> rows) {
    Transaction transaction(database_);
    Statement points = database_.prepare(
        fmt::format("INSERT OR REPLACE INTO points VALUES({})", placeholders(columns().size())));
    Statement emulation = database_.prepare("INSERT OR REPLACE INTO emulation VALUES(?, ?, ?, ?)");
    for (const SweepRow& row : rows) {
        const SweepResult& result = row.result;
        const bool failed = !result.error.empty();
        int at = 0;
        points.bind(++at, row.key);
        points.bind(++at, row.config);
        bind(points, ++at, row.scene ? Cell(*row.scene) : Cell(nullptr));
        for (const std::string& value : row.values) {
            points.bind(++at, value);
        }
        points.bind(++at, failed ? "failed" : "done");
        bind(points, ++at, failed ? Cell(result.error) : Cell(nullptr));
        for (std::size_t i = 0; i < run_figures().size(); ++i) {
            bind(points, ++at, failed ? Cell(nullptr) : result.figures.at(i));
        }
        points.run();
        emulation.bind(1, row.key).bind(2, result.fingerprint).bind(3, result.wall_seconds);
        bind(emulation, 4,
             result.wall_seconds > 0 ? Cell(result.machine_seconds / result.wall_seconds)
                                     : Cell(nullptr));
        emulation.run();
    }
    transaction.commit();
    for (const SweepRow& row : rows) {
        known_[row.key] = {row.result.fingerprint, !row.result.error.empty()};
    }
}

std::string SweepTable::csv() const {
    Statement rows = database_.prepare("SELECT * FROM points ORDER BY key");
    const std::span<const Figure> figures = run_figures();
    const auto first_figure = rows.columns() - static_cast<int>(figures.size());
    std::string text;
    for (int column = 0; column < rows.columns(); ++column) {
        text.append(column == 0 ? "" : ",").append(csv_text(rows.column_name(column)));
    }
    text += "\n";
    while (rows.step()) {
        for (int column = 0; column < rows.columns(); ++column) {
            const bool is_real =
                column >= first_figure &&
                figures[static_cast<std::size_t>(column - first_figure)].type == "REAL";
            text.append(column == 0 ? "" : ",").append(csv_cell(rows, column, is_real));
        }
        text += "\n";
    }
    return text;
}

}  // namespace rasterloom::observe
