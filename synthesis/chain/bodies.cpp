#include "synthesis/chain/bodies.hpp"

#include <algorithm>

namespace cognate::synthesis {
namespace {

using Body = std::vector<int>;

Body* body_of(std::vector<Body>& all, int first, int second) {
  const auto found = std::ranges::find_if(all, [&](const Body& body) {
    return std::ranges::count(body, first) > 0 && std::ranges::count(body, second) > 0;
  });
  return found == all.end() ? nullptr : &*found;
}

struct Assembled {
  std::vector<Body> bodies{{}};
  std::vector<int> joints;
  int third_from = -1;  ///< the point from which the third pin of the next three-pin link is held

  void add_pin(const ChainLine& line, int index) {
    joints.push_back(index);
    const bool is_third = line.type == LineType::third_pin;
    bodies.push_back({is_third ? third_from : line.first, index});
    if (is_third) bodies.push_back({line.first, line.second, index});
  }

  void add(const ChainLine& line, int index) {
    if (line.type == LineType::pivot || line.type == LineType::guide) {
      bodies.front().push_back(index);
    } else if (is_three_pin(line.type)) {
      add_pin(line, index);
    } else if (line.type == LineType::third_link) {
      third_from = line.first;
    } else if (line.type == LineType::drawn || line.type == LineType::heading) {
      return;
    } else if (line.type == LineType::crank) {
      bodies.push_back({line.first, index});
    } else if (Body* common = body_of(bodies, line.first, line.second)) {
      common->push_back(index);
    } else if (is_dyad(line.type)) {
      joints.push_back(index);
      bodies.push_back({line.first, index});
      bodies.push_back(line.type == LineType::dyad ? Body{line.second, index} : Body{index});
    }
  }
};

Assembled assembled(const Chain& chain) {
  Assembled all;
  for (std::size_t k = 0; k < chain.lines.size(); ++k) all.add(chain.lines[k], static_cast<int>(k));
  return all;
}

}  // namespace

std::vector<Body> bodies(const Chain& chain) {
  return assembled(chain).bodies;
}

std::vector<int> joints(const Chain& chain) {
  return assembled(chain).joints;
}

}  // namespace cognate::synthesis
