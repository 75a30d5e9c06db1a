#include "problems/mechanism/drawn/groups.hpp"

#include <algorithm>
#include <utility>

#include "problems/mechanism/drawn/determined_links.hpp"

namespace cognate::problems::reading {
namespace {

/// Takes groups off a drawing, one after another, dyads first.
class Decomposition {
 public:
  Decomposition(const Drawing& drawing, std::size_t driven)
      : drawing_(drawing), moves_(drawing.links.size(), false), of_(drawing.links.size()) {
    moves_[0] = moves_[driven] = true;
    for (std::size_t i = 0; i < of_.size(); ++i) of_[i] = joints_of(drawing, i);
  }

  DrawnGroups run() {
    DrawnGroups groups;
    for (bool is_found = true; is_found;) {
      is_found = false;
      if (const auto dyad = next()) {
        moves_[dyad->first] = moves_[dyad->second] = true;
        groups.groups.emplace_back(*dyad);
        is_found = true;
      } else if (const auto links = determined_links(drawing_, moves_); !links.empty()) {
        for (const std::size_t link : links) moves_[link] = true;
        groups.groups.emplace_back(DrawnGroup{links});
        is_found = true;
      }
    }
    for (std::size_t i = 0; i < moves_.size(); ++i) {
      if (!moves_[i]) groups.left.push_back(i);
    }
    return groups;
  }

 private:
  bool is_held(const DrawnJoint& joint) const {
    return std::ranges::any_of(joint.of, [&](std::size_t link) { return moves_[link]; });
  }

  /// The joint by which what moves already holds `link`; empty where there are none or several.
  std::optional<std::size_t> outer(std::size_t link) const {
    std::optional<std::size_t> found;
    for (const std::size_t i : of_[link]) {
      if (!is_held(drawing_.joints[i])) continue;
      if (found) return std::nullopt;
      found = i;
    }
    return found;
  }

  /// The first two links of an inner joint that are held on the outside.
  std::optional<DrawnDyad> dyad_at(std::size_t inner) const {
    const DrawnJoint& joint = drawing_.joints[inner];
    if (joint.of.size() < 2 || is_held(joint)) return std::nullopt;
    std::vector<std::pair<std::size_t, std::size_t>> held;
    for (const std::size_t link : joint.of) {
      if (const auto by = outer(link)) held.emplace_back(link, *by);
    }
    if (held.size() < 2) return std::nullopt;
    return DrawnDyad{held[0].first, held[1].first, held[0].second, inner, held[1].second};
  }

  std::optional<DrawnDyad> next() const {
    for (std::size_t i = 0; i < drawing_.joints.size(); ++i) {
      if (const auto dyad = dyad_at(i)) return dyad;
    }
    return std::nullopt;
  }

  const Drawing& drawing_;
  std::vector<bool> moves_;
  std::vector<std::vector<std::size_t>> of_;
};

}  // namespace

std::optional<std::size_t> shared_link(const Drawing& drawing, const DrawnDyad& dyad) {
  for (const std::size_t link : drawing.joints[dyad.first_outer].of) {
    const bool is_own = link == dyad.first || link == dyad.second;
    if (!is_own && joins(drawing.joints[dyad.second_outer], link)) return link;
  }
  return std::nullopt;
}

DrawnGroups groups_of(const Drawing& drawing, std::size_t driven) {
  return Decomposition(drawing, driven).run();
}

DrawnMobility mobility_of(const Drawing& drawing) {
  DrawnMobility mobility{.links = drawing.links.size()};
  for (const DrawnJoint& joint : drawing.joints) mobility.joints += joint.of.size() - 1;
  return mobility;
}

}  // namespace cognate::problems::reading
