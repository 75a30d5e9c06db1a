/// @file Names of bodies and points in an analysis file: which are fit, and what they stand for.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "problems/mechanism/named_parts.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Bodies and points that are there by now, and the names of points that are still to come. A name
/// is found in constant time: a file may have thousands of each.
class PartNames {
 public:
  PartNames() : PartNames(NamedParts{}) {}
  explicit PartNames(NamedParts parts);

  const NamedParts& parts() const { return parts_; }

  /// The place of a point in `parts().points`; empty where it is not placed yet.
  std::optional<std::size_t> point(const std::string& name) const;
  /// The number of a body; empty where there is none.
  std::optional<int> body(const std::string& name) const;
  /// Whether the file names a point so, placed or not yet.
  bool is_announced(const std::string& name) const { return announced_index_.contains(name); }
  /// The names of all points of the file, the placed ones first, each once.
  std::vector<std::string_view> all_points() const;

  void announce(const std::string& point);
  void add_body(Body body);
  /// Adds a body to those on which `point` is known to be fixed.
  void place(const std::string& point, const Attached<double>& on);

  /// Whether a part was left out because of a fault. What depends on it is not found, and that is
  /// no further fault.
  bool incomplete = false;

 private:
  NamedParts parts_;
  std::vector<std::string> announced_;
  std::unordered_set<std::string> announced_index_;
  std::unordered_map<std::string, std::size_t> points_;
  std::unordered_map<std::string, int> bodies_;
};

/// The string under `key` where it is fit to name a part: 1 to 40 letters, digits or one of
/// - _ . ' so that it can head a column of a table. Empty with a fault where it is not; empty
/// without one where the file has no such key.
std::optional<std::string> read_name(TableReader& table, std::string_view key);

/// As `read_name` where the name must be there; `what` says what it names.
std::optional<std::string> require_name(TableReader& table, std::string_view key,
                                        std::string_view what);

/// Whether `name` is fit; adds a fault at `where` to `table` where it is not. `called` is the name
/// of the value in the message.
bool check_name(TableReader& table, Where where, std::string_view called, std::string_view name);

/// A name in a file, and where it stands.
struct Mention {
  std::string name;
  Where where;
  std::string called;  ///< "dyad[2].joins": the value that mentions it
};

/// The string under `key` as a mention; empty, with a fault where it is no string.
std::optional<Mention> read_mention(TableReader& table, std::string_view key);

/// The strings under `key`, an array of `count`, or one string where one is enough.
std::optional<std::vector<Mention>> read_mentions(TableReader& table, std::string_view key,
                                                  const Count& count);

/// Takes note of a point that the file names; a fault where another has the name.
void announce(PartNames& names, const Mention& point, FaultList& faults);

/// Adds a body. `pin`: of a slider, the point that it may share its name with; else empty. A fault
/// where a body or another point has the name.
void add_body(PartNames& names, const Mention& body, bool slider, std::string_view pin,
              FaultList& faults);

/// Whether `faults` has as many as are reported; then a fault at `mention` is added in few words.
/// The other words, of thousands of names, would cost time that no one has use of.
bool fault_briefly(const Mention& mention, FaultList& faults);

/// The place in `names.parts().points` of the point that is mentioned; a fault where it has none
/// yet.
std::optional<std::size_t> find_point(const PartNames& names, const Mention& mention,
                                      FaultList& faults);

/// The number of the body that is mentioned; a fault where there is none.
std::optional<int> find_body(const PartNames& names, const Mention& mention, FaultList& faults);

/// Which of its bodies a point is taken to belong to where only one can be meant: the slider that
/// it is the pin of, else the last, that which the drive moves through all the others.
Attached<double> bearer(const NamedParts& parts, const PointOnLink& point);

/// A body and the axes in which points of it are given: where their origin and first axis stand in
/// the body's own.
struct Axes {
  int body = 0;
  Vec2d origin{};
  Vec2d direction{1, 0};
};

/// The axes that one or two names define: a body's own; those of the slider that a single point is
/// the pin of; or, of two points of one body, the origin at the first and the first axis towards
/// the second. A fault where they define none.
std::optional<Axes> find_axes(const PartNames& names, const std::vector<Mention>& mentions,
                              FaultList& faults);

/// `words` in quotation marks, as many as a message has room for.
std::string listed(std::vector<std::string_view> words);

/// "\"A\", \"B\"": the names of all points, of all bodies.
std::string point_list(const PartNames& names);
std::string body_list(const NamedParts& parts, const std::vector<Attached<double>>& places);

}  // namespace cognate::problems::reading
