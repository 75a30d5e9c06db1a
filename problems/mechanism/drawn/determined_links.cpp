#include "problems/mechanism/drawn/determined_links.hpp"

#include <algorithm>
#include <utility>

namespace cognate::problems::reading {
namespace {

/// Equations of joints and the coordinates that they are matched to. Nodes are the links, then the
/// pins; a link has three coordinates, a pin two.
class Matching {
 public:
  Matching(const Drawing& drawing, const std::vector<bool>& moves)
      : links_(moves.size()), nodes_(moves.size() + drawing.joints.size()) {
    for (std::size_t i = 0; i < links_; ++i) nodes_[i].coordinates = moves[i] ? 0 : 3;
    for (std::size_t i = 0; i < drawing.joints.size(); ++i) add(drawing.joints[i], i, moves);
    for (std::size_t i = 0; i < equations_.size(); ++i) {
      std::vector<bool> visited(nodes_.size(), false);
      match(i, visited);
    }
  }

  /// The links that `link` depends on, itself among them; empty where they have a coordinate that
  /// nothing determines.
  std::vector<std::size_t> needed_by(std::size_t link) const {
    std::vector<std::size_t> found{link};
    std::vector<bool> known(nodes_.size(), false);
    known[link] = true;
    for (std::size_t next = 0; next < found.size(); ++next) {
      const Node& node = nodes_[found[next]];
      if (node.matched.size() < node.coordinates) return {};
      for (const std::size_t equation : node.matched) {
        for (const std::size_t other : equations_[equation]) {
          if (!known[other]) found.push_back(other);
          known[other] = true;
        }
      }
    }
    std::erase_if(found, [&](std::size_t node) { return node >= links_; });
    std::ranges::sort(found);
    return found;
  }

 private:
  struct Node {
    std::size_t coordinates = 0;
    std::vector<std::size_t> matched;  ///< equations
  };

  void add_two(const std::vector<std::size_t>& nodes) {
    equations_.push_back(nodes);
    equations_.push_back(nodes);
  }

  void add(const DrawnJoint& joint, std::size_t number, const std::vector<bool>& moves) {
    std::vector<std::size_t> waiting = joint.of;
    const auto moving = std::erase_if(waiting, [&](std::size_t link) { return moves[link]; });
    if (waiting.size() + moving < 2 || waiting.empty()) return;
    if (joint.direction) return add_two(waiting);
    const std::size_t pin = links_ + number;
    if (moving == 0) nodes_[pin].coordinates = 2;
    for (const std::size_t link : waiting) {
      moving == 0 ? add_two({link, pin}) : add_two({link});
    }
  }

  /// Finds a coordinate for `equation`, others making room for it (Kuhn 1955).
  bool match(std::size_t equation, std::vector<bool>& visited) {
    for (const std::size_t at : equations_[equation]) {
      if (visited[at]) continue;
      visited[at] = true;
      Node& node = nodes_[at];
      if (node.matched.size() < node.coordinates) {
        node.matched.push_back(equation);
        return true;
      }
      for (std::size_t& held : node.matched) {
        if (!match(held, visited)) continue;
        held = equation;
        return true;
      }
    }
    return false;
  }

  std::size_t links_;
  std::vector<Node> nodes_;
  std::vector<std::vector<std::size_t>> equations_;
};

}  // namespace

std::vector<std::size_t> determined_links(const Drawing& drawing, const std::vector<bool>& moves) {
  const Matching matching(drawing, moves);
  std::vector<std::size_t> least;
  for (std::size_t link = 0; link < moves.size(); ++link) {
    if (moves[link]) continue;
    auto links = matching.needed_by(link);
    if (!links.empty() && (least.empty() || links.size() < least.size())) least = std::move(links);
  }
  return least;
}

}  // namespace cognate::problems::reading
