/// @file The parts of a mechanism while it is read, found by name.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "problems/mechanism/named_parts.hpp"

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
  /// Takes note that `point` is fixed on a body, besides those that it is known to be on.
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

}  // namespace cognate::problems::reading
