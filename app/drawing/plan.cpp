#include "app/drawing/plan.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::app {
namespace {

/// The width of a letter as a share of its height, of sans-serif and of the letters of CAD, about;
/// that of Chinese and Japanese ones.
constexpr double kLetter = 0.62, kWideLetter = 1.0;

class Bounds {
 public:
  void add(const Vec2d& centre, double reach) {
    low_ = {std::min(low_.x, centre.x - reach), std::min(low_.y, centre.y - reach)};
    high_ = {std::max(high_.x, centre.x + reach), std::max(high_.y, centre.y + reach)};
  }

  void add(const PlanOutline& outline) {
    const auto& corners = outline.corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2d& next = corners[(i + 1) % corners.size()].at;
      // An arc is nowhere farther from its chord than its rise.
      const double rise = 0.5 * std::abs(corners[i].bulge) * norm(next - corners[i].at);
      add(corners[i].at, rise);
      if (rise > 0) add(next, rise);
    }
  }

  /// With what hangs below the line.
  void add(const PlanLabel& label) {
    constexpr double kBelow = 0.25;
    add(label.at - Vec2d{0, kBelow * label.height}, 0);
    add(label.at + Vec2d{text_width(label.text, label.height), label.height}, 0);
  }

  void give(Plan& plan) const {
    if (!(low_.x <= high_.x)) return;
    plan.low = low_;
    plan.high = high_;
  }

 private:
  Vec2d low_{kInfinity, kInfinity};
  Vec2d high_{-kInfinity, -kInfinity};
};

}  // namespace

void fit_to_shapes(Plan& plan) {
  Bounds bounds;
  for (const auto& outline : plan.outlines) bounds.add(outline);
  for (const auto& circle : plan.circles) bounds.add(circle.centre, circle.radius);
  for (const auto& label : plan.labels) bounds.add(label);
  bounds.give(plan);
}

double text_width(std::string_view text, double height) {
  double letters = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool goes_on = (byte & 0xC0U) == 0x80;
    if (!goes_on) letters += byte >= 0xE3 ? kWideLetter : kLetter;
  }
  return letters * height;
}

PlanOutline plan_line(const std::string& layer, const Vec2d& from, const Vec2d& to) {
  return {layer, {{from}, {to}}, false};
}

}  // namespace cognate::app
