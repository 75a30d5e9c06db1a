/// @file Typed access to one table of a problem file, which collects what is wrong with it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "problems/basics/names.hpp"
#include "problems/basics/range.hpp"
#include "problems/toml/document.hpp"
#include "problems/toml/fault_list.hpp"
#include "problems/toml/number_rules.hpp"

namespace cognate::problems::reading {

/// How many entries an array may have. `of`: what they are, in the plural.
struct Count {
  std::size_t min = 0;
  std::size_t max = 10000;
  std::string_view of = "entries";
};

/// Two numbers in brackets: a point, a pair, an interval.
using Two = std::array<double, 2>;

/// Reads the keys of one table. A number may be written as a string that holds an expression
/// without variables, "170*2*pi/60". Every getter returns the value of `key`, or nothing where the
/// file does not have it or has something else there; the latter adds a fault. A key that was
/// requested is known; `finish` faults all others.
class TableReader {
 public:
  /// The reader of the document itself. `document` and `faults` must outlive every reader.
  TableReader(const Table& document, FaultList& faults);

  /// The table under `key`; an empty one where the file has none.
  TableReader table(std::string_view key);

  /// The tables under `key`, `[[key]]` or an array of inline tables; what is no table is faulted
  /// and left out. Their names are "key[1]", "key[2]"…
  std::vector<TableReader> tables(std::string_view key, const Count& count);

  std::optional<std::string> text(std::string_view key);
  /// An array of strings.
  std::optional<std::vector<std::string>> texts(std::string_view key, const Count& count);
  std::optional<bool> boolean(std::string_view key);
  std::optional<int> integer(std::string_view key, int min, int max);
  std::optional<double> number(std::string_view key, const NumberRule& rule);
  std::optional<std::vector<double>> numbers(std::string_view key, const NumberRule& rule,
                                             const Count& count);

  /// A speed in rad/s under `key`, or in turns a minute under `key` followed by "_rpm".
  std::optional<double> turning_speed(std::string_view key, const NumberRule& rule);
  /// Whether the file has either; both keys are then known.
  bool has_speed(std::string_view key);

  /// As `numbers`, every entry that is right in its place and nothing for the wrong ones, so that
  /// the right ones can be checked further; empty where there is no such array.
  std::vector<std::optional<double>> each_number(std::string_view key, const NumberRule& rule,
                                                 const Count& count);

  /// As `each_number`, of which some may be the word `none` instead; `is_number` says which are
  /// not.
  std::vector<std::optional<double>> each_number_or(std::string_view key, std::string_view none,
                                                    const NumberRule& rule, const Count& count,
                                                    std::vector<bool>& is_number);

  /// `form` is how the two are written, "[x, y]".
  std::optional<Two> two(std::string_view key, const NumberRule& rule, std::string_view form);
  std::optional<std::vector<Two>> twos(std::string_view key, const NumberRule& rule,
                                       std::string_view form, const Count& count);
  /// To `twos` what `each_number` is to `numbers`.
  std::vector<std::optional<Two>> each_two(std::string_view key, const NumberRule& rule,
                                           std::string_view form, const Count& count);

  /// An array of arrays of numbers, each with at most `most` of them and perhaps none; `form` is
  /// how the whole is written.
  std::optional<std::vector<std::vector<double>>> lists(std::string_view key,
                                                        const NumberRule& rule,
                                                        std::string_view form, const Count& count,
                                                        std::size_t most);

  /// As `each_two` for rows of `width` numbers, and for pairs of points [[x, y], [x, y]].
  std::vector<std::optional<std::vector<double>>> each_row(std::string_view key, std::size_t width,
                                                           const NumberRule& rule,
                                                           std::string_view form,
                                                           const Count& count);
  std::vector<std::optional<std::array<Two, 2>>> each_segment(std::string_view key,
                                                              const NumberRule& rule,
                                                              std::string_view form,
                                                              const Count& count);

  std::optional<Vec2d> point(std::string_view key);
  /// `[min, max]` with min ≤ max.
  std::optional<Range> range(std::string_view key, const NumberRule& rule);
  /// `[[xmin, ymin], [xmax, ymax]]` with min ≤ max in both.
  std::optional<Box> box(std::string_view key);

  /// One of the names of `Enum`.
  template <class Enum>
  std::optional<Enum> choice(std::string_view key) {
    std::vector<std::string_view> allowed;
    for (const auto& named : names<Enum>()) allowed.push_back(named.name);
    const auto index = choice_of(key, allowed);
    return index ? std::optional(names<Enum>()[*index].value) : std::nullopt;
  }
  /// The place of the string under `key` in `allowed`.
  std::optional<std::size_t> choice_of(std::string_view key,
                                       std::span<const std::string_view> allowed);

  /// Whether the file has `key`, with a right value or a wrong one; the key is then known.
  bool has(std::string_view key);

  /// As `has`, but does not make the key known.
  bool contains(std::string_view key) const { return peek(key) != nullptr; }

  /// Whether the file has a string, a table, or an array under `key`. None makes the key known.
  bool has_text(std::string_view key) const;
  bool has_table(std::string_view key) const;
  bool has_array(std::string_view key) const;
  /// Whether the array under `key` holds the string `word`; this makes no key known either.
  bool has_word(std::string_view key, std::string_view word) const;

  /// Where the value of `key` begins, or its entry `index`; the table where there is none.
  Where where(std::string_view key) const;
  Where where(std::string_view key, std::size_t index) const;
  Where where() const { return where_; }

  /// Where byte `offset` of the string under `key` stands; its beginning where it was written with
  /// escapes or over several lines.
  Where where_in_text(std::string_view key, std::size_t offset) const;

  /// "target.points".
  std::string name(std::string_view key) const;

  /// Adds a fault at `key`, its message `rest` preceded by the key's name.
  void fault(std::string_view key, std::string_view rest);

  /// Makes keys known that are looked at only in some cases.
  void know(std::initializer_list<std::string_view> keys);

  /// Faults every key that was never requested.
  void finish();

  FaultList& faults() const { return *faults_; }

 private:
  TableReader(const Table* table, std::string name, Where where, FaultList& faults);

  const Node* find(std::string_view key);
  const Node* peek(std::string_view key) const;
  const Array* array(std::string_view key, const Count& count, std::string_view wanted);
  void wrong_type(const Node& node, const std::string& name, std::string_view wanted);
  std::optional<double> value_at(const Node& node, const std::string& name,
                                 std::string_view wanted);
  std::optional<double> number_at(const Node& node, const std::string& name,
                                  const NumberRule& rule);
  const Array* row_at(const Node& node, const std::string& name, std::size_t width,
                      std::string_view form);
  std::optional<Two> two_at(const Node& node, const std::string& name, const NumberRule& rule,
                            std::string_view form);

  const Table* table_;  // null for a table that the file does not have
  std::string name_;
  Where where_;
  FaultList* faults_;
  std::vector<std::string> known_;
};

/// The entries, if there are any and all of them have a value.
template <class T>
std::optional<std::vector<T>> all_or_none(const std::vector<std::optional<T>>& entries) {
  std::vector<T> values;
  for (const auto& entry : entries) {
    if (!entry) return std::nullopt;
    values.push_back(*entry);
  }
  return values.empty() ? std::nullopt : std::optional(std::move(values));
}

/// Of two tables that may both hold `key`, the one that does, `first` where neither does. Holding
/// it twice is a fault. The key is known in both afterwards.
TableReader& holder(std::string_view key, TableReader& first, TableReader& second);

}  // namespace cognate::problems::reading
