// SPDX-License-Identifier: MIT
#include "machine/observe/database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

namespace rasterloom::observe {

namespace {

constexpr int kPatience = 10'000;  // milliseconds

int primary(int code) {
    return code & 0xff;
}

std::string reason(sqlite3* connection, int code) {
    switch (primary(code)) {
        case SQLITE_NOTADB:
            return "is no SQLite file";
        case SQLITE_CORRUPT:
            return "is damaged, perhaps cut off";
        case SQLITE_CANTOPEN:
            return "cannot be opened";
        case SQLITE_FULL:
            return "cannot be written: no room on the disk";
        case SQLITE_IOERR:
            return "cannot be read or written: the file system refuses (no room, or a limit?)";
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return "is in use by another program";
        case SQLITE_READONLY:
            return "cannot be written: not permitted";
        default:
            return connection != nullptr ? sqlite3_errmsg(connection) : sqlite3_errstr(code);
    }
}

[[noreturn]] void fail(const std::string& path, sqlite3* connection, int code) {
    throw DatabaseError(fmt::format("{}: {}", path, reason(connection, code)), code);
}

bool succeeded(int code) {
    return code == SQLITE_OK || code == SQLITE_ROW || code == SQLITE_DONE;
}

}  // namespace

bool DatabaseError::is_full() const {
    return primary(code_) == SQLITE_FULL;
}

bool DatabaseError::is_foreign() const {
    return primary(code_) == SQLITE_NOTADB || primary(code_) == SQLITE_CORRUPT;
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
    sqlite3_finalize(statement);
}

void Statement::check(int code) const {
    if (!succeeded(code)) {
        sqlite3* connection = sqlite3_db_handle(statement_.get());
        fail(sqlite3_db_filename(connection, "main"), connection, code);
    }
}

Statement& Statement::bind(int parameter, std::int64_t value) {
    check(sqlite3_bind_int64(statement_.get(), parameter, value));
    return *this;
}

Statement& Statement::bind(int parameter, double value) {
    check(sqlite3_bind_double(statement_.get(), parameter, value));
    return *this;
}

Statement& Statement::bind(int parameter, std::string_view value) {
    // A null pointer would bind NULL.
    const char* text = value.data() != nullptr ? value.data() : "";
    check(sqlite3_bind_text64(statement_.get(), parameter, text, value.size(), SQLITE_TRANSIENT,
                              SQLITE_UTF8));
    return *this;
}

Statement& Statement::bind(int parameter, std::nullptr_t) {
    check(sqlite3_bind_null(statement_.get(), parameter));
    return *this;
}

bool Statement::step() {
    const int code = sqlite3_step(statement_.get());
    if (code == SQLITE_ROW) {
        return true;
    }
    if (code != SQLITE_DONE) {
        try {
            check(code);
        } catch (...) {
            reset();
            throw;
        }
    }
    reset();
    return false;
}

void Statement::run() {
    while (step()) {
    }
}

void Statement::reset() {
    sqlite3_reset(statement_.get());  // repeats the last step's error, which was thrown there
}

template <>
std::int64_t Statement::column<std::int64_t>(int index) const {
    return sqlite3_column_int64(statement_.get(), index);
}

template <>
double Statement::column<double>(int index) const {
    return sqlite3_column_double(statement_.get(), index);
}

template <>
std::string Statement::column<std::string>(int index) const {
    // In this order: asking for the text may convert the value, and so change its size.
    const unsigned char* text = sqlite3_column_text(statement_.get(), index);
    const int size = sqlite3_column_bytes(statement_.get(), index);
    return text == nullptr
               ? std::string()
               : std::string(reinterpret_cast<const char*>(text), static_cast<std::size_t>(size));
}

bool Statement::is_null(int index) const {
    return sqlite3_column_type(statement_.get(), index) == SQLITE_NULL;
}

int Statement::columns() const {
    return sqlite3_column_count(statement_.get());
}

std::string Statement::column_name(int index) const {
    return sqlite3_column_name(statement_.get(), index);
}

void Database::Close::operator()(sqlite3* connection) const {
    sqlite3_close_v2(connection);
}

void Database::check(int code) const {
    if (!succeeded(code)) {
        fail(path_.string(), connection_.get(), code);
    }
}

Database Database::open(const std::filesystem::path& path, Access access) {
    const std::filesystem::path full = std::filesystem::absolute(path);
    const int flags =
        access == Access::read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    sqlite3* connection = nullptr;
    // One thread at a time uses a database.
    const int code =
        sqlite3_open_v2(full.c_str(), &connection, flags | SQLITE_OPEN_NOMUTEX, nullptr);
    Database database(path, connection);  // to be closed though it did not open
    database.check(code);
    sqlite3_extended_result_codes(connection, 1);
    sqlite3_busy_timeout(connection, kPatience);
    database.prepare("SELECT count(*) FROM sqlite_master").run();
    return database;
}

void Database::execute(const std::string& sql) {
    check(sqlite3_exec(connection_.get(), sql.c_str(), nullptr, nullptr, nullptr));
}

Statement Database::prepare(std::string_view sql) const {
    sqlite3_stmt* statement = nullptr;
    check(sqlite3_prepare_v2(connection_.get(), sql.data(), static_cast<int>(sql.size()),
                             &statement, nullptr));
    return Statement(statement);
}

Transaction::Transaction(Database& database) : database_(database) {
    database_.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
    if (open_) {
        try {
            database_.execute("ROLLBACK");
        } catch (const DatabaseError&) {
            // A full disk has rolled back by itself; otherwise the next who opens the file does.
        }
    }
}

void Transaction::commit() {
    database_.execute("COMMIT");
    open_ = false;
}

std::string sql_name(std::string_view name) {
    std::string text(1, '"');
    for (const char c : name) {
        text += c;
        if (c == '"') {
            text += c;
        }
    }
    text += '"';
    return text;
}

}  // namespace rasterloom::observe
