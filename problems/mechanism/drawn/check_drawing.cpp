#include "problems/mechanism/drawn/check_drawing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/mechanism/group.hpp"
#include "problems/mechanism/part_names.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

using Links = std::vector<std::size_t>;

/// A fault of the whole: where the joints begin.
void fault(const TableReader& place, std::string message) {
  place.faults().add(place.where("joint"), std::move(message));
}

std::string link_list(const Drawing& drawing, const Links& links) {
  std::vector<std::string_view> words;
  for (const std::size_t link : links) words.push_back(drawing.links[link]);
  return listed(std::move(words));
}

/// Two links with two joints cannot move on one another.
void check_pairs(const Drawing& drawing, FaultList& faults) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> joined;
  for (std::size_t j = 0; j < drawing.joints.size(); ++j) {
    const DrawnJoint& joint = drawing.joints[j];
    for (const std::size_t a : joint.of) {
      for (const std::size_t b : joint.of) {
        if (a >= b) continue;
        const auto [pair, is_new] = joined.try_emplace({a, b}, j);
        if (is_new) continue;
        faults.add(joint.where,
                   fmt::format("joints {} both join {} and {}, which cannot move on "
                               "one another; expected one link in their place",
                               joint_names(drawing, {pair->second, j}), in_quotes(drawing.links[a]),
                               in_quotes(drawing.links[b])));
      }
    }
  }
}

/// The links that one joint alone joins to others, the drive left out: they hang on it.
Links loose(const Drawing& drawing, const Links& among) {
  Links found;
  for (const std::size_t link : among) {
    const auto joints = joints_of(drawing, link);
    const auto count = std::ranges::count_if(
        joints, [&](std::size_t i) { return drawing.joints[i].of.size() > 1; });
    if (count < 2 && link != drawing.driven) found.push_back(link);
  }
  return found;
}

/// The links that no joints join to the frame.
Links apart_from_frame(const Drawing& drawing) {
  std::vector<bool> joined(drawing.links.size(), false);
  joined[0] = true;
  for (bool grows = true; grows;) {
    grows = false;
    for (const DrawnJoint& joint : drawing.joints) {
      const bool here = std::ranges::any_of(joint.of, [&](std::size_t i) { return joined[i]; });
      for (const std::size_t link : joint.of) {
        grows = grows || (here && !joined[link]);
        joined[link] = joined[link] || here;
      }
    }
  }
  Links apart;
  for (std::size_t i = 1; i < joined.size(); ++i) {
    if (!joined[i]) apart.push_back(i);
  }
  return apart;
}

void check_mobility(const Drawing& drawing, const DrawnGroups& groups, TableReader& place) {
  const DrawnMobility mobility = mobility_of(drawing);
  std::string message = fmt::format(
      "the drawing has mobility 3(n - 1) - 2j = {} with n = {} links and j = {} joints; expected 1",
      mobility.value(), mobility.links, mobility.joints);
  const Links hanging = loose(drawing, groups.left);
  if (!hanging.empty()) {
    message += fmt::format("; one joint alone holds {}", link_list(drawing, hanging));
  } else if (const Links apart = apart_from_frame(drawing); !apart.empty()) {
    message += fmt::format("; nothing joins {} to the frame", link_list(drawing, apart));
  } else if (mobility.value() > 1) {
    message += "; join more of its links, or fix a pin to the frame";
  } else {
    message += "; a joint or a link holds it";
  }
  fault(place, message);
}

/// Whether all links move as dyads where `link` drives.
bool leaves_dyads(const Drawing& drawing, std::size_t link) {
  const DrawnGroups groups = groups_of(drawing, link);
  return groups.left.empty() && std::ranges::all_of(groups.groups, [&](const auto& group) {
           const auto* dyad = std::get_if<DrawnDyad>(&group);
           return dyad && !shared_link(drawing, *dyad);
         });
}

/// The links with a joint on the frame whose drive would leave dyads alone.
Links drives_of_dyads(const Drawing& drawing) {
  Links found;
  for (std::size_t link = 1; link < drawing.links.size(); ++link) {
    const bool on_frame = std::ranges::any_of(drawing.joints, [&](const DrawnJoint& joint) {
      return joins(joint, 0) && joins(joint, link);
    });
    if (on_frame && leaves_dyads(drawing, link)) found.push_back(link);
  }
  return found;
}

void check_groups(const Drawing& drawing, const DrawnGroups& groups, TableReader& place) {
  if (groups.left.empty()) return;
  const Links hanging = loose(drawing, groups.left);
  if (!hanging.empty()) {
    return fault(place,
                 fmt::format("the drawing has mobility 1 as a whole, but one joint alone holds "
                             "{}, and others hold what should move",
                             link_list(drawing, hanging)));
  }
  fault(place, fmt::format("the drawing has links of which a part is held beside one that is "
                           "loose: {}",
                           link_list(drawing, groups.left)));
}

/// A group has a matrix of all its joints.
void check_sizes(const Drawing& drawing, const DrawnGroups& groups, TableReader& place) {
  for (const auto& any : groups.groups) {
    const auto* group = std::get_if<DrawnGroup>(&any);
    if (!group || group->links.size() <= kMostGroupBodies) continue;
    std::string message =
        fmt::format("the drawing has {} links that move only together: {}; expected at most {}",
                    group->links.size(), link_list(drawing, group->links), kMostGroupBodies);
    const Links drives = drives_of_dyads(drawing);
    if (!drives.empty()) {
      message += fmt::format("; driven by {} they would move in pairs", link_list(drawing, drives));
    }
    fault(place, message);
  }
}

}  // namespace

void check_drawing(const Drawing& drawing, const DrawnGroups& groups, TableReader& place) {
  const std::size_t before = place.faults().size();
  check_pairs(drawing, place.faults());
  if (place.faults().size() != before) return;
  if (drawing.links.size() == 2) {
    return fault(place, "the drawing moves the driven link alone; expected links that it moves");
  }
  if (mobility_of(drawing).value() != 1) return check_mobility(drawing, groups, place);
  check_groups(drawing, groups, place);
  check_sizes(drawing, groups, place);
}

}  // namespace cognate::problems::reading
