// SPDX-License-Identifier: MIT
// A SQLite file: opened, asked, closed by scope. Every error is an exception that names the file.
#pragma once

#include "machine/observe/output_folder.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace rasterloom::observe {

// The file cannot be read or written, or is none of SQLite's.
class DatabaseError : public OutputError {
  public:
    // `code`: SQLite's extended result code.
    DatabaseError(const std::string& message, int code) : OutputError(message), code_(code) {}

    bool is_full() const;     // no room on the disk
    bool is_foreign() const;  // no SQLite file, or a damaged one

  private:
    int code_;
};

// One prepared statement. Parameters and columns count as SQLite's do: parameters from 1, columns
// from 0. Must not outlive its database.
class Statement {
  public:
    Statement& bind(int parameter, std::int64_t value);
    Statement& bind(int parameter, double value);
    Statement& bind(int parameter, std::string_view value);  // copied
    Statement& bind(int parameter, std::nullptr_t);

    // True: a row is there. After the last row the statement is as new but for its parameters.
    bool step();
    // For a statement without rows, or whose rows do not matter.
    void run();
    // Back to before the first row; parameters stay.
    void reset();

    // Of the present row; SQLite converts. T: std::int64_t, double or std::string (NULL: 0, "").
    template <typename T>
    T column(int index) const;
    bool is_null(int index) const;
    int columns() const;
    std::string column_name(int index) const;

  private:
    friend class Database;
    struct Finalize {
        void operator()(sqlite3_stmt* statement) const;
    };

    explicit Statement(sqlite3_stmt* statement) : statement_(statement) {}
    void check(int code) const;

    std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

template <>
std::int64_t Statement::column<std::int64_t>(int index) const;
template <>
double Statement::column<double>(int index) const;
template <>
std::string Statement::column<std::string>(int index) const;

class Database {
  public:
    enum class Access : std::uint8_t {
        read,    // the file must be there
        change,  // made when it is not there
    };

    // Reads the file's first page, so that a foreign file is refused here. Waits a while for
    // another process that holds the file.
    static Database open(const std::filesystem::path& path, Access access);

    // One statement or several, without parameters; rows are dropped.
    void execute(const std::string& sql);
    Statement prepare(std::string_view sql) const;

    const std::filesystem::path& path() const { return path_; }

  private:
    struct Close {
        void operator()(sqlite3* connection) const;
    };

    Database(std::filesystem::path path, sqlite3* connection)
        : path_(std::move(path)), connection_(connection) {}
    void check(int code) const;

    std::filesystem::path path_;
    std::unique_ptr<sqlite3, Close> connection_;
};

// Everything between its making and commit() is in the file whole or not at all.
class Transaction {
  public:
    explicit Transaction(Database& database);
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    ~Transaction();  // takes back what was not committed

    void commit();

  private:
    Database& database_;
    bool open_ = true;
};

// `name` as SQL writes a column or table whose name is no plain word.
std::string sql_name(std::string_view name);

}  // namespace rasterloom::observe
