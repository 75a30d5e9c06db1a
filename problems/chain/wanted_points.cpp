#include "problems/chain/wanted_points.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "problems/chain/places.hpp"
#include "problems/mechanism/part_names.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

class WantedPoints {
 public:
  WantedPoints(Topology& topology, const WantedTables& tables, const Wanted& wanted)
      : topology_(topology), tables_(tables), wanted_(wanted), places_(chain_of(topology).lines) {}

  void choose() {
    names_ = wanted_.points.empty() ? std::vector{last_point()} : wanted_.points;
    for (const std::string& name : names_) {
      const auto found = std::ranges::find_if(topology_.lines, [&](const TopologyLine& line) {
        return line.name == name && is_point(line.line.type);
      });
      if (found == topology_.lines.end()) {
        return tables_.target.fault(
            wanted_.key, fmt::format("is {}, which is no point of the chain; expected one of {}",
                                     in_quotes(name), quoted_points(topology_)));
      }
      lines_.push_back(static_cast<int>(found - topology_.lines.begin()));
    }
    topology_.trace = lines_.back();
    wanted_.slides ? check_slider() : names_.size() == 1 ? check_path() : check_link();
  }

  /// A point that those wanted do not close on has no dimension that could be found.
  void check_all_count() {
    const std::vector<bool> counts = those_that_count();
    const std::string what =
        wanted_.slides ? "displacement of " + in_quotes(names_[0])
        : names_.size() == 1
            ? "path of " + in_quotes(names_[0])
            : fmt::format("angle from {} to {}", in_quotes(names_[0]), in_quotes(names_[1]));
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if (counts[i] || !is_point(topology_.lines[i].line.type)) continue;
      const std::string& name = topology_.lines[i].name;
      TableReader& table = table_of(name);
      table.faults().add(table.where(),
                         fmt::format("{} has no influence on the {}; remove it, or name "
                                     "another target.{}",
                                     in_quotes(name), what, wanted_.key));
    }
  }

 private:
  void fault(const std::string& text) {
    TableReader& place = tables_.target.has(wanted_.key) ? tables_.target : tables_.mechanism;
    place.fault(wanted_.key, text);
  }

  void check_slider() {
    const auto& line = topology_.lines[static_cast<std::size_t>(topology_.trace)].line;
    if (line.type == synthesis::LineType::slider) return;
    fault(
        fmt::format("is {}, which is no slider; expected the `new` of a [[dyad]] with "
                    "type = \"RRP\", or two points of a link",
                    in_quotes(names_[0])));
  }

  void check_path() {
    const int body = places_.place(topology_.trace).first;
    if (body > 1) return;
    fault(
        fmt::format("is {}, a point of the {}; expected a point of another link, whose path can "
                    "be designed",
                    in_quotes(names_[0]), body == 0 ? "frame" : "crank"));
  }

  void check_link() {
    const auto body =
        lines_[0] == lines_[1] ? std::nullopt : places_.common_body(lines_[0], lines_[1]);
    if (body && *body > 1) return;
    const std::string_view what = !body       ? "which are not two points of one link"
                                  : *body > 0 ? "points of the crank"
                                              : "points of the frame";
    fault(
        fmt::format("is [\"{}\", \"{}\"], {}; expected two points of a link whose angle can be "
                    "designed",
                    names_[0], names_[1], what));
  }

  /// The last `[[point]]`; without one the last joint.
  std::string last_point() const {
    if (!tables_.parts.points.empty()) return *tables_.parts.points.back().text("name");
    return std::ranges::find_if(topology_.lines.rbegin(), topology_.lines.rend(),
                                [](const TopologyLine& line) { return is_point(line.line.type); })
        ->name;
  }

  /// The lines of a three-pin link, of which `last` is the last: it stands as a whole.
  static void count_together(std::vector<bool>& counts, std::size_t last) {
    const auto from = counts.begin() + static_cast<std::ptrdiff_t>(last) - synthesis::kThirdPin;
    const auto to = counts.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    if (std::find(from, to, true) != to) std::fill(from, to, true);
  }

  /// The lines on which those wanted depend.
  std::vector<bool> those_that_count() const {
    std::vector<bool> counts(topology_.lines.size());
    for (const int line : lines_) counts[static_cast<std::size_t>(line)] = true;
    for (std::size_t i = topology_.lines.size(); i-- > 0;) {
      const synthesis::ChainLine& line = topology_.lines[i].line;
      if (line.type == synthesis::LineType::third_pin) count_together(counts, i);
      for (const int before : {line.first, line.second}) {
        if (counts[i] && before >= 0) counts[static_cast<std::size_t>(before)] = true;
      }
    }
    return counts;
  }

  TableReader& table_of(const std::string& name) {
    for (auto& [type, tables] : tables_.parts.all()) {
      for (TableReader& table : *tables) {
        for (const std::string_view key : {"name", "pin", "new"}) {
          if (table.has_text(key) && *table.text(key) == name) return table;
        }
      }
    }
    return tables_.mechanism;
  }

  Topology& topology_;
  const WantedTables& tables_;
  const Wanted& wanted_;
  ChainPlaces places_;
  std::vector<std::string> names_;
  std::vector<int> lines_;
};

}  // namespace

bool choose_wanted(Topology& topology, const WantedTables& tables, const Wanted& wanted) {
  const FaultList& faults = tables.mechanism.faults();
  const std::size_t before = faults.size();
  WantedPoints points(topology, tables, wanted);
  points.choose();
  if (faults.size() == before) points.check_all_count();
  return faults.size() == before;
}

std::string quoted_points(const Topology& topology) {
  std::vector<std::string_view> known;
  for (const TopologyLine& line : topology.lines) {
    if (is_point(line.line.type)) known.push_back(line.name);
  }
  return quoted_list(known);
}

}  // namespace cognate::problems::reading
