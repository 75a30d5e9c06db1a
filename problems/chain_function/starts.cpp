#include "problems/chain_function/starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/random.hpp"
#include "problems/chain/output/dyad.hpp"
#include "synthesis/chain/transform.hpp"

namespace cognate::problems {
namespace {

constexpr int kChains = 48, kPivots = 24;
/// Of the positions of a chain that must turn fully, those while the function is generated.
constexpr int kGenerating = 40;
constexpr double kNoFit = std::numeric_limits<double>::infinity();

/// Positions of the crank: first those at which the output counts, then of a crank that must turn
/// fully the whole turn.
class Positions {
 public:
  Positions(const ChainFunctionSpace& space, double start)
      : count_(space.needs_turn ? kGenerating : kDrawnPositions) {
    for (int i = 0; i < kDrawnPositions; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double turned =
          i < count_ ? std::lerp(space.sweep.min, space.sweep.max, double(i) / (count_ - 1))
                     : kTurn * (i - count_) / (kDrawnPositions - count_);
      cranks_[at] = unit_vector(start + turned);
      outputs_[at] = space.wanted(space.output_at(turned));
    }
  }

  const DrawnCurve& cranks() const { return cranks_; }
  std::size_t count() const { return static_cast<std::size_t>(count_); }
  /// What the output is to be, from the start.
  const WantedOutput& output(std::size_t i) const { return outputs_[i]; }

 private:
  int count_;
  DrawnCurve cranks_;
  std::array<WantedOutput, kDrawnPositions> outputs_;
};

class FunctionDraw {
 public:
  FunctionDraw(const ChainFunctionSpace& space, std::mt19937_64& random)
      : space_(space), random_(random) {}

  std::optional<ChainFunctionDesign> best() {
    if (space_.slides() ? ends_in_free_slider(space_) : ends_in_free_dyad(space_)) {
      draw_on_circles();
    }
    // Where no circle is near, the dyad on the nearest need not close.
    if (!chosen() || !std::isfinite(error_of(*chosen()))) {
      best_inside_ = best_ = {};
      draw_whole();
    }
    return chosen();
  }

 private:
  void draw_on_circles() {
    const OutputCarrier carrier(space_, {std::acos(space_.cosine_limit), kPi});
    // The best of few are of more valleys than the best of many.
    const int chains =
        space_.slides() ? int(std::exp(uniform(random_, 0, std::log(kChains + 1)))) : kChains;
    for (int i = 0; i < chains; ++i) {
      const double start = uniform(random_, 0, kTurn);
      const Positions positions(space_, start);
      const auto drawn = draw(carrier.space(), positions.cranks(), random_);
      if (!drawn) continue;
      for (int k = 0; k < kPivots; ++k) {
        space_.slides() ? hang_slider(carrier.space(), *drawn, positions, start)
                        : hang_output(*drawn, positions, start);
      }
    }
  }

  /// Seen from the slider its pin stands still. A carrier without dimensions of its own is turned
  /// and enlarged first.
  void hang_slider(const ChainSpace& carrier, const DrawnChain& drawn, const Positions& positions,
                   double start) {
    const double turned = is_carrier_free_ ? uniform(random_, 0, kTurn) : 0;
    const double size = is_carrier_free_ ? std::exp(uniform(random_, -1, 1)) : 1;
    const Vec2d turn = size * unit_vector(turned);
    const auto given = guide_direction(space_);
    const Vec2d guide = unit_vector(given.value_or(uniform(random_, -kPi / 2, kPi / 2)));
    const auto path = std::span(drawn.curve).first(positions.count());
    seen_.clear();
    for (std::size_t i = 0; i < path.size(); ++i) {
      seen_.push_back(turn * path[i] - positions.output(i).displacement * guide);
    }
    const CircleNear circle = circle_near(seen_);
    const double error = circle.deviation / least_effect(circle, guide);
    if (!(error < best_inside_.error)) return;
    synthesis::ChainDesign chain = drawn.design;
    synthesis::transform(carrier.lines, turn, {}, chain.parameters);
    if (const auto whole = with_slider(space_, chain, guide, circle, seen_[0])) {
      take({*whole, start + turned}, error);
    }
  }

  /// The least sine of the transmission angle of the slider's link: what the link is too short
  /// moves the slider by so much more. Zero where the link does not stay on one side of its dead
  /// points, within the limit with some allowance.
  double least_effect(const CircleNear& circle, const Vec2d& guide) const {
    double least = kNoFit, greatest = -kNoFit;
    for (const Vec2d& point : seen_) {
      const Vec2d link = (1 / norm(circle.centre - point)) * (circle.centre - point);
      least = std::min(least, dot(guide, link));
      greatest = std::max(greatest, dot(guide, link));
      if (!(std::abs(cross(guide, link)) < most_cosine())) return 0;
    }
    return least * greatest > 0 ? std::min(std::abs(least), std::abs(greatest)) : 0;
  }

  double most_cosine() const {
    constexpr double kAllowance = 0.15;
    return std::min(space_.cosine_limit + kAllowance, 0.995);
  }

  void hang_output(const DrawnChain& carrier, const Positions& positions, double start) {
    const auto path = std::span(carrier.curve).first(positions.count());
    const Vec2d pivot = pivot_beside(path);
    seen_.clear();
    for (std::size_t i = 0; i < path.size(); ++i) {
      seen_.push_back(pivot + conj(positions.output(i).direction) * (path[i] - pivot));
    }
    const CircleNear circle = circle_near(seen_);
    const double error = circle.deviation / norm(circle.centre - pivot);
    if (!(error < best_inside_.error) || !dyad_closes(circle, pivot)) return;
    if (const auto chain = hung(space_, carrier.design, pivot, circle, seen_[0])) {
      take({*chain, start}, error);
    }
  }

  const std::optional<ChainFunctionDesign>& chosen() const {
    return best_inside_.design ? best_inside_.design : best_.design;
  }

  void take(const ChainFunctionDesign& design, double error) {
    const bool is_inside =
        within_bounds(space_, design.chain).parameters == design.chain.parameters;
    Best& best = is_inside ? best_inside_ : best_;
    if (error < best.error) best = {design, error};
  }

  /// A point as far from the middle of a path as it is long, some times more or less.
  Vec2d pivot_beside(std::span<const Vec2d> path) {
    constexpr double kNearest = 0.3, kFarthest = 8;
    Vec2d middle;
    for (const Vec2d& point : path) middle = middle + (1.0 / double(path.size())) * point;
    double square = 0;
    for (const Vec2d& point : path) square += squared_norm(point - middle) / double(path.size());
    const double distance = std::exp(uniform(random_, std::log(kNearest), std::log(kFarthest)));
    return middle + distance * std::sqrt(square) * unit_vector(uniform(random_, 0, kTurn));
  }

  /// Whether the dyad stays on one side of its dead points, within the limit with some allowance.
  bool dyad_closes(const CircleNear& circle, const Vec2d& pivot) const {
    double least = kNoFit, greatest = -kNoFit;
    for (const Vec2d& point : seen_) {
      const Vec2d arm = pivot - circle.centre, link = point - circle.centre;
      const double scale = norm(arm) * norm(link);
      const double sine = cross(arm, link) / scale;
      least = std::min(least, sine);
      greatest = std::max(greatest, sine);
      if (!(std::abs(dot(arm, link)) / scale < most_cosine())) return false;
    }
    return least * greatest > 0;
  }

  void draw_whole() {
    if (has_three_pin_link(*space_.topology)) return draw_over_turn();
    constexpr int kWholeChains = 200;
    for (int i = 0; i < kWholeChains; ++i) {
      const double start = uniform(random_, 0, kTurn);
      const Positions positions(space_, start);
      const auto drawn = draw(space_, positions.cranks(), random_);
      if (drawn) begin_at(drawn->design, start);
    }
  }

  /// A three-pin link is led over the whole turn, so that each chain is tried from many starts.
  void draw_over_turn() {
    constexpr int kDraws = 60, kStarts = 12;
    for (int i = 0; i < kDraws; ++i) {
      const auto drawn = draw(space_, random_);
      const double first = uniform(random_, 0, kTurn);
      for (int k = 0; drawn && k < kStarts; ++k) {
        begin_at(drawn->design, first + kTurn * k / kStarts);
      }
    }
  }

  void begin_at(const synthesis::ChainDesign& chain, double start) {
    const ChainFunctionDesign design{chain, start};
    take(design, error_of(design));
  }

  double error_of(const ChainFunctionDesign& design) const {
    const ChainFunctionModel model(space_, design, {}, space_.coarse,
                                   synthesis::Objective::max_abs);
    std::vector<double> errors(space_.coarse.size());
    if (!model.residuals(model.start(), errors, {}, {})) return kNoFit;
    const auto [least, greatest] = std::ranges::minmax(errors);
    return greatest - least;
  }

  const ChainFunctionSpace& space_;
  std::mt19937_64& random_;
  bool is_carrier_free_ = has_free_carrier(space_);
  std::vector<Vec2d> seen_;  ///< the carrying point, from the output
  struct Best {
    std::optional<ChainFunctionDesign> design;
    double error = kNoFit;
  };
  Best best_inside_, best_;  ///< within the bounds and beyond, where a fit begins at their nearest
};

}  // namespace

std::optional<ChainFunctionDesign> draw_chain_function(const ChainFunctionSpace& space,
                                                       std::mt19937_64& random) {
  return FunctionDraw(space, random).best();
}

}  // namespace cognate::problems
