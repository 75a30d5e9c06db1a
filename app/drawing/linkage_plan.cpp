#include "app/drawing/linkage_plan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

// As shares of the linkage's size.
constexpr double kJoint = 0.02, kPoint = 0.013, kTarget = 0.026, kText = 0.05, kBase = 0.08,
                 kBlock = 0.06;

class PlanMaker {
 public:
  PlanMaker(const LinkShapes& shown, std::span<const BodyMotion<double, 0>> bodies)
      : shown_(shown), bodies_(bodies), size_(size_of(shown)) {}

  Plan make(const LinkageScene& linkage, const std::vector<PointPath>& paths) {
    plan_.title = linkage.problem.title.empty()
                      ? std::string(problems::to_string(linkage.problem.mechanism.type()))
                      : linkage.problem.title;
    plan_.layers = {{"FRAME", PlanColour::grey},
                    {"GUIDES", PlanColour::grey, true},
                    {"LINKS"},
                    {"JOINTS"},
                    {"POINTS"},
                    {"PATHS", PlanColour::accent},
                    {"TARGET", PlanColour::red},
                    {"LABELS", PlanColour::green}};
    int layers = 0;
    for (const LinkShape& link : shown_.links) layers = std::max(layers, link.layer);
    for (int layer = 1; layer <= layers; ++layer) plan_.layers.push_back({links_layer(layer)});
    for (const auto& path : paths) add_path(path);
    for (std::size_t i = 0; i < shown_.links.size(); ++i) add_link(i);
    for (const Vec2d& target : linkage.targets) {
      plan_.circles.push_back({"TARGET", target, kTarget * size_});
    }
    fit_to_shapes(plan_);
    return std::move(plan_);
  }

 private:
  Vec2d placed(std::size_t link, const Vec2d& at) const {
    return bodies_[link].origin[0] + bodies_[link].direction * at;
  }

  void add_path(const PointPath& path) {
    PlanOutline outline{"PATHS", {}, path.closed};
    for (const Vec2d& corner : path.corners) outline.corners.push_back({corner});
    plan_.outlines.push_back(std::move(outline));
  }

  void add_link(std::size_t link) {
    const LinkShape& given = shown_.links[link];
    for (const Rail& rail : given.shape.rails) {
      plan_.outlines.push_back(plan_line("GUIDES", placed(link, rail.from), placed(link, rail.to)));
    }
    const std::string layer = links_layer(given.layer);
    add_polygon(link, layer, given.shape.outline);
    if (given.shape.block) {
      const double a = kBlock * size_, b = 0.6 * a;
      add_polygon(link, layer, {{-a, -b}, {a, -b}, {a, b}, {-a, b}});
    }
    for (const LinkPlace& place : given.places) add_place(link, place);
  }

  static std::string links_layer(int layer) {
    return layer > 0 ? fmt::format("LINKS_{}", layer) : "LINKS";
  }

  void add_polygon(std::size_t link, const std::string& layer, const std::vector<Vec2d>& corners) {
    if (corners.size() < 2) return;
    PlanOutline outline{layer, {}, corners.size() > 2};
    for (const Vec2d& corner : corners) outline.corners.push_back({placed(link, corner)});
    plan_.outlines.push_back(std::move(outline));
  }

  /// A joint is on two links: it is drawn and named once. What lies at another's position just now
  /// is named beside it.
  void add_place(std::size_t link, const LinkPlace& place) {
    const Vec2d at = placed(link, place.at);
    if (link == 0 && place.joint) add_base(at);
    if (!named_.insert(place.name).second) return;
    const auto is_here = [&](const Vec2d& other) {
      return norm(other - at) <= kOnePlace * (size_ + norm(at));
    };
    const auto before = std::ranges::count_if(places_, is_here);
    places_.push_back(at);
    if (before == 0) {
      plan_.circles.push_back(
          {place.joint ? "JOINTS" : "POINTS", at, (place.joint ? kJoint : kPoint) * size_});
    }
    plan_.labels.push_back(label_at(at, place.name, static_cast<int>(before)));
  }

  /// The first label of a place is to the upper right of it, others to the lower right, to the
  /// upper left, to the lower left and then farther off.
  PlanLabel label_at(const Vec2d& at, const std::string& name, int before) const {
    const double aside = 1.5 * kJoint * size_, height = kText * size_;
    const bool left = before % 4 >= 2, below = before % 2 == 1;
    const double x = left ? -aside - text_width(name, height) : aside;
    const double y = below ? -aside - 0.75 * height : aside;
    const int round = before / 4;
    const double further = 1.2 * height * round;
    return {"LABELS", at + Vec2d{x, below ? y - further : y + further}, height, name};
  }

  void add_base(const Vec2d& at) {
    const double a = kBase * size_;
    const std::array<Vec2d, 3> corners = {Vec2d{}, {-0.7 * a, -a}, {0.7 * a, -a}};
    PlanOutline outline{"FRAME", {}, true};
    for (const Vec2d& corner : corners) outline.corners.push_back({at + corner});
    plan_.outlines.push_back(std::move(outline));
  }

  const LinkShapes& shown_;
  std::span<const BodyMotion<double, 0>> bodies_;
  double size_;
  std::set<std::string> named_;
  std::vector<Vec2d> places_;  ///< of what is named
  Plan plan_;
};

}  // namespace

Plan linkage_plan(const LinkageScene& linkage, const LinkShapes& shown,
                  std::span<const BodyMotion<double, 0>> bodies,
                  const std::vector<PointPath>& paths) {
  return PlanMaker(shown, bodies).make(linkage, paths);
}

}  // namespace cognate::app
