#include "problems/linkage/twins.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

constexpr double kSameLinks = 1e-6;

/// What of two four-bars of the same links is not the same.
class Comparison {
 public:
  Comparison(const FourBar& a, const FourBar& b) : a_(a), b_(b), x_(lengths(a)), y_(lengths(b)) {
    allowed_ = kSameLinks * std::max({x_.crank, x_.coupler, x_.rocker, x_.frame});
  }

  bool same_links() const {
    return near(x_.crank, y_.crank) && near(x_.coupler, y_.coupler) && near(x_.rocker, y_.rocker) &&
           near(x_.frame, y_.frame) &&
           a_.coupler_point.has_value() == b_.coupler_point.has_value() &&
           (!a_.coupler_point ||
            (near(a_.coupler_point->x, b_.coupler_point->x) &&
             near(std::abs(a_.coupler_point->y), std::abs(b_.coupler_point->y))));
  }

  bool is_mirrored() const {
    return a_.assembly != b_.assembly && a_.coupler_point &&
           near(a_.coupler_point->y, -b_.coupler_point->y);
  }

  std::vector<std::string> differences(bool mirrored) const {
    std::vector<std::string> all;
    if (a_.assembly != b_.assembly) all.emplace_back("assembly");
    const double turn = std::remainder(frame_angle(a_) - frame_angle(b_), kTurn);
    if (mirrored || std::abs(turn) > kSameLinks) all.emplace_back("direction");
    if (!(norm(a_.pivot_a - b_.pivot_a) <= allowed_)) all.emplace_back("pivots");
    const bool other_side = a_.coupler_point && !near(a_.coupler_point->y, b_.coupler_point->y);
    if (other_side && !mirrored) all.emplace_back("coupler point");
    return all;
  }

 private:
  bool near(double a, double b) const { return std::abs(a - b) <= allowed_; }

  const FourBar &a_, &b_;
  Lengths<double> x_, y_;
  double allowed_ = 0;
};

}  // namespace

void mark_twins(std::vector<Design>& designs) {
  for (std::size_t i = 0; i < designs.size(); ++i) {
    Design& design = designs[i];
    const FourBar* own = design.mechanism.four_bar();
    if (!own || design.cognate_of) continue;
    if (design.mirror_of) {
      const auto& other = designs[static_cast<std::size_t>(*design.mirror_of)];
      if (other.mechanism.four_bar()) {
        design.differs = Comparison(*other.mechanism.four_bar(), *own).differences(true);
      }
      continue;
    }
    for (std::size_t k = 0; k < i; ++k) {
      const FourBar* other = designs[k].mechanism.four_bar();
      if (!other || designs[k].twin_of || designs[k].mirror_of) continue;
      const Comparison comparison(*other, *own);
      if (!comparison.same_links()) continue;
      const bool mirrored = comparison.is_mirrored();
      design.differs = comparison.differences(mirrored);
      if (design.differs.empty()) continue;
      (mirrored ? design.mirror_of : design.twin_of) = static_cast<int>(k);
      break;
    }
  }
}

}  // namespace cognate::problems
