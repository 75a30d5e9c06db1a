#include "app/study/sqlite.hpp"

#include <sqlite3.h>

#include <cmath>
#include <variant>

namespace cognate::app {
namespace {

constexpr int kBusyMilliseconds = 5000;

[[noreturn]] void fail(sqlite3* connection, int code) {
  throw SqliteError(code & 0xff,
                    connection != nullptr ? sqlite3_errmsg(connection) : sqlite3_errstr(code));
}

}  // namespace

void SqliteStatement::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

void SqliteStatement::check(int code) {
  if (code != SQLITE_OK) fail(sqlite3_db_handle(statement_.get()), code);
}

void SqliteStatement::bind(int parameter, std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), parameter, value));
}

void SqliteStatement::bind(int parameter, double value) {
  check(sqlite3_bind_double(statement_.get(), parameter, value));
}

void SqliteStatement::bind(int parameter, std::string_view text) {
  check(sqlite3_bind_text64(statement_.get(), parameter, text.data(), text.size(), SQLITE_STATIC,
                            SQLITE_UTF8));
}

void SqliteStatement::bind(int parameter, const problems::Cell& cell) {
  const auto* number = std::get_if<double>(&cell);
  if (number != nullptr && std::isfinite(*number)) {
    bind(parameter, *number);
  } else if (const auto* word = std::get_if<std::string>(&cell)) {
    bind(parameter, std::string_view(*word));
  } else {
    check(sqlite3_bind_null(statement_.get(), parameter));
  }
}

bool SqliteStatement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  // Says the error of the step once more, if there was one.
  check(sqlite3_reset(statement_.get()));
  return false;
}

void SqliteStatement::run() {
  while (step()) continue;
}

void SqliteStatement::reset() {
  sqlite3_reset(statement_.get());
}

int SqliteStatement::columns() const {
  return sqlite3_column_count(statement_.get());
}

bool SqliteStatement::is_null(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

bool SqliteStatement::is_text(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_TEXT;
}

std::int64_t SqliteStatement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double SqliteStatement::real(int column) const {
  return sqlite3_column_double(statement_.get(), column);
}

std::string_view SqliteStatement::view(int column) const {
  const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement_.get(), column));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return bytes != nullptr ? std::string_view(bytes, size) : std::string_view();
}

problems::Cell SqliteStatement::cell(int column) const {
  switch (sqlite3_column_type(statement_.get(), column)) {
    case SQLITE_NULL:
      return std::monostate();
    case SQLITE_INTEGER:
    case SQLITE_FLOAT:
      return real(column);
    case SQLITE_TEXT:
      return text(column);
    default:
      throw SqliteError(SQLITE_CORRUPT, "a value is neither a number nor a word");
  }
}

SqliteDatabase::SqliteDatabase(const std::filesystem::path& file, Access access) {
  // A name that begins with "file:" is a name like any other, and so is an empty one.
  const std::string name = std::filesystem::absolute(file).string();
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  // SQLite would wait for the other end of a pipe.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw SqliteError(SQLITE_NOTADB, "it is no regular file");
  }
  const int flags =
      access == Access::read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  connect(name, flags);
}

SqliteDatabase SqliteDatabase::temporary() {
  SqliteDatabase database;
  database.connect("", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  return database;
}

void SqliteDatabase::connect(const std::string& name, int flags) {
  sqlite3* connection = nullptr;
  const int code = sqlite3_open_v2(name.c_str(), &connection, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  connection_.reset(connection);
  if (code != SQLITE_OK) fail(connection, code);
  sqlite3_busy_timeout(connection, kBusyMilliseconds);
}

void SqliteDatabase::Close::operator()(sqlite3* connection) const {
  sqlite3_close_v2(connection);
}

SqliteStatement SqliteDatabase::prepare(std::string_view sql) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v3(connection_.get(), sql.data(), static_cast<int>(sql.size()),
                                      SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
  if (code != SQLITE_OK) fail(connection_.get(), code);
  return SqliteStatement(statement);
}

void SqliteDatabase::execute(const std::string& sql) {
  const int code = sqlite3_exec(connection_.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(connection_.get(), code);
}

std::string SqliteDatabase::text(std::string_view sql) {
  auto statement = prepare(sql);
  return statement.step() ? statement.text(0) : std::string();
}

std::int64_t SqliteDatabase::integer(std::string_view sql) {
  auto statement = prepare(sql);
  return statement.step() ? statement.integer(0) : 0;
}

bool SqliteDatabase::in_transaction() const {
  return sqlite3_get_autocommit(connection_.get()) == 0;
}

bool SqliteDatabase::has_moved() const {
  int moved = 0;
  sqlite3_file_control(connection_.get(), "main", SQLITE_FCNTL_HAS_MOVED, &moved);
  return moved != 0;
}

std::string sql_name(std::string_view name) {
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"') text += '"';
    text += c;
  }
  return text + '"';
}

}  // namespace cognate::app
