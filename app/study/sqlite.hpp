/// @file SQLite's connections and statements as objects that close themselves, its errors as
/// exceptions.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "problems/study/block.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace cognate::app {

/// What SQLite says went wrong, in its own words.
class SqliteError : public std::runtime_error {
 public:
  SqliteError(int code, const std::string& what) : std::runtime_error(what), code_(code) {}
  int code() const { return code_; }  ///< SQLITE_FULL, SQLITE_CORRUPT, …, without the extension

 private:
  int code_;
};

/// A prepared statement. Parameters count from 1, columns from 0, as in SQLite.
class SqliteStatement {
 public:
  void bind(int parameter, std::int64_t value);
  void bind(int parameter, double value);
  /// `text` stays as it is until the statement has been stepped.
  void bind(int parameter, std::string_view text);
  /// A cell with nothing in it is null, and so is a number that is not finite.
  void bind(int parameter, const problems::Cell& cell);

  /// True with the next row; false at the end, and the statement can be used again.
  bool step();
  /// Runs a statement that gives no rows.
  void run();
  /// Begins again, regardless of what has been read.
  void reset();

  int columns() const;
  bool is_null(int column) const;
  bool is_text(int column) const;
  std::int64_t integer(int column) const;
  double real(int column) const;
  /// Valid until the next step.
  std::string_view view(int column) const;
  std::string text(int column) const { return std::string(view(column)); }
  problems::Cell cell(int column) const;

 private:
  friend class SqliteDatabase;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  explicit SqliteStatement(sqlite3_stmt* statement) : statement_(statement) {}
  void check(int code);

  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/// A connection. Waits some seconds where another one holds the database.
class SqliteDatabase {
 public:
  enum class Access { read, write_or_create };
  SqliteDatabase(const std::filesystem::path& file, Access access);
  /// An empty one that is gone with the connection; what does not fit into some MiB of memory is in
  /// a file of SQLite's where the system has temporary files.
  static SqliteDatabase temporary();

  SqliteStatement prepare(std::string_view sql);
  /// Runs statements that give no rows.
  void execute(const std::string& sql);
  /// The first value of the first row, as text; empty where there is none.
  std::string text(std::string_view sql);
  /// The same as a whole number, 0 where there is none.
  std::int64_t integer(std::string_view sql);
  bool in_transaction() const;
  /// Whether the file was removed, or another one took its name, since it was opened.
  bool has_moved() const;

 private:
  struct Close {
    void operator()(sqlite3* connection) const;
  };
  SqliteDatabase() = default;
  void connect(const std::string& name, int flags);

  std::unique_ptr<sqlite3, Close> connection_;
};

/// `name` as SQL writes the name of a column, in double quotes.
std::string sql_name(std::string_view name);

}  // namespace cognate::app
