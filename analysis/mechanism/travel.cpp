#include "analysis/mechanism/travel.hpp"

#include <algorithm>
#include <variant>

namespace cognate {
namespace {

Travel turning(int body) {
  return {.body = body};
}

Travel sliding(int body, const Guide<double>& guide) {
  return {body, true, on_guide(body, guide)};
}

/// Of the drive's bodies, which come first.
struct OfDrive {
  std::vector<Travel>& all;

  void operator()(const Crank<double>&) const { all.push_back(turning(1)); }
  void operator()(const DrivingSlider<double>& slider) const {
    all.push_back(sliding(1, slider.guide));
  }
  void operator()(const FloatingLink<double>& link) const {
    all.insert(all.end(), {turning(1), sliding(2, link.first), sliding(3, link.second)});
  }
  void operator()(const DrivingRod<double>&) const {
    all.push_back({1, true, {1, {2, {0, 0}}, {1, 0}}});
  }
};

/// Of a dyad's two bodies, whose numbers are next.
struct OfDyad {
  std::vector<Travel>& all;
  int first = static_cast<int>(all.size());

  void operator()(const Rrr<double>&) const { append(turning(first), turning(first + 1)); }
  void operator()(const Rrp<double>& dyad) const {
    append(turning(first), sliding(first + 1, dyad.guide));
  }
  void operator()(const Rpr<double>&) const { append(turning(first), turning(first + 1)); }
  void operator()(const Prp<double>& dyad) const {
    append(sliding(first, dyad.first), sliding(first + 1, dyad.second));
  }
  void operator()(const Rpp<double>& dyad) const {
    append({first, true, {first, {first + 1, {0, 0}}, dyad.slot}}, sliding(first + 1, dyad.guide));
  }
  void operator()(const Cylinder<double>&) const { append(turning(first), turning(first + 1)); }
  void operator()(const Group& group) const {
    for (std::size_t i = 0; i < group.drawn.size(); ++i) {
      const int body = first + static_cast<int>(i);
      const auto slides = [&](const GroupJoint& joint) {
        return joint.slides && joint.second.body == body;
      };
      const auto slide = std::ranges::find_if(group.joints, slides);
      all.push_back(slide == group.joints.end()
                        ? turning(body)
                        : Travel{body, true, {body, slide->first, slide->along_first}});
    }
  }
  void operator()(const GroupRest&) const {}
  void append(const Travel& of_first, const Travel& of_second) const {
    all.insert(all.end(), {of_first, of_second});
  }
};

}  // namespace

std::vector<Travel> travels(const Mechanism<double>& mechanism) {
  std::vector<Travel> all{turning(0)};
  std::visit(OfDrive{all}, mechanism.drive);
  for (const Dyad<double>& dyad : mechanism.dyads) std::visit(OfDyad{all}, dyad);
  return all;
}

}  // namespace cognate
