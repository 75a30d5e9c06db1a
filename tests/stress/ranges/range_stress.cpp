#include "tests/stress/ranges/range_stress.hpp"

#include <algorithm>
#include <cmath>

#include "tests/stress/ranges/range_cases.hpp"
#include "tests/stress/ranges/range_judge.hpp"

namespace cognate::stress {
namespace {

/// Degrees, or parts of the longest length: next to dead points the brute force has half of its
/// digits.
constexpr double kTolerance = 2e-7;
/// Of the lengths or radians: next to a change point of a mechanism with slides, whose places come
/// from rounded coordinates, extremes go with the root of the rounding.
constexpr double kOfRoots = 1e-6;
/// Degrees: what the rounding of a crank angle makes of a swing next to a change point, times the
/// distance from it, a part of the longest length.
constexpr double kOfPlace = 2e-14;

/// The same links with the coupler fixed: what was the rocker turns as the crank.
SingleLoop on_coupler(const SingleLoop& l) {
  SingleLoop other = l;
  other.crank = l.rocker, other.coupler = std::hypot(l.frame_x, l.frame_y), other.rocker = l.crank;
  other.frame_x = l.coupler, other.frame_y = 0;
  return other;
}

/// The mirror image, driven from D.
SingleLoop from_d(const SingleLoop& l) {
  SingleLoop other = l;
  std::swap(other.crank, other.rocker);
  if (l.tie == Tie::kite_b_on_d) other.tie = Tie::kite_c_on_a;
  if (l.tie == Tie::kite_c_on_a) other.tie = Tie::kite_b_on_d;
  if (l.tie == Tie::single && l.equal_sum != 2) other.equal_sum = 4 - l.equal_sum;
  return other;
}

/// Of a four-bar, by whether crank and rocker turn against the frame, and against the coupler.
std::string class_of(const SingleLoop& l, bool crank_turns, bool rocker_turns, bool near_tie) {
  if (crank_turns) return rocker_turns ? "double-crank" : "crank-rocker";
  if (rocker_turns) return "rocker-crank";
  return truth_of(on_coupler(l), near_tie).crank_turns ? "double-rocker" : "triple-rocker";
}

std::string kind_of(const SingleLoop& l, const LoopTruth& truth) {
  switch (l.tie) {
    case Tie::none:
      return "";
    case Tie::single:
      return "single";
    case Tie::parallelogram:
      return truth.keeps_direction ? "parallelogram" : "antiparallelogram";
    case Tie::rhombus:
      return "rhombus";
    default:
      return "kite";
  }
}

std::string class_of_slider(const SingleLoop& l, bool crank_turns) {
  if (crank_turns) return "rotating-crank";
  SingleLoop exchanged = l;
  std::swap(exchanged.crank, exchanged.coupler);
  return truth_of(exchanged, true).crank_turns ? "rotating-coupler" : "no-rotation";
}

class LoopCheck {
 public:
  LoopCheck(const LoopCase& drawn, RangeTally& tally)
      : loop_(drawn.loop),
        near_tie_(drawn.is_near_tie),
        nearness_(drawn.nearness),
        truth_(truth_of(loop_, near_tie_)),
        tally_(tally),
        judge_(file_of(loop_), tally) {}

  void run() {
    ++tally_.mechanisms;
    tally_.at_ties += loop_.tie != Tie::none;
    tally_.near_ties += near_tie_ && loop_.tie == Tie::none;
    tally_.several_ranges += truth_.ranges > 1;
    if (!judge_.is_read()) return;
    check_class();
    if (!truth_.closes) {
      ++tally_.none_closes;
      judge_.is_true("nothing closes", judge_.result().closed_rows == 0, "rows close");
      return;
    }
    check_strokes();
    check_transmission();
    judge_.landmarks({"dead point", "end of range"}, truth_.dead_points, 1e-6);
    judge_.landmarks({"change point", "undetermined change point"}, truth_.change_points, 1e-6);
  }

 private:
  bool is_guide() const {
    return loop_.type == LoopType::guide_bar || loop_.type == LoopType::oscillating_block;
  }
  bool is_slider_crank() const {
    return loop_.type == LoopType::slider_crank || loop_.type == LoopType::fixed_block;
  }

  void check_class() {
    if (loop_.type == LoopType::four_bar) {
      const bool rocker = truth_of(from_d(loop_), near_tie_).crank_turns;
      const std::string name = class_of(loop_, truth_.crank_turns, rocker, near_tie_);
      ++tally_.classes[name];
      judge_.text("class", name);
      judge_.flag("rocker_turns_fully", rocker);
      if (truth_.closes) judge_.text("change_point_kind", kind_of(loop_, truth_));
    } else if (is_slider_crank()) {
      judge_.text("class", class_of_slider(loop_, truth_.crank_turns));
    } else if (!is_guide()) {
      return;
    }
    judge_.flag("crank_turns_fully", truth_.crank_turns);
    judge_.flag("change_point", loop_.tie != Tie::none);
  }

  void check_strokes() {
    const bool slides = loop_.slides();
    const std::string what = slides ? "stroke" : "swing_deg";
    const bool is_full = !slides && truth_.stroke > 360 - 1e-6;
    tally_.turn += is_full;
    tally_.come_round += !is_full && !slides && truth_.circuit == 360;
    const bool none = is_full || truth_.reaches_infinity;
    const auto own = none ? std::nullopt : std::optional(truth_.stroke);
    for (const auto& [name, truth] : {std::pair("output_" + what, own),
                                      std::pair("circuit_" + what, none ? own : truth_.circuit)}) {
      // Nearly a whole turn is one or the other by rounding.
      const double full = slides ? 0 : truth.value_or(360);
      const auto said = judge_.number_said(name);
      const bool is_turn = full >= 360 - 1e-6 && said && *said >= 360 - 1e-6 - tolerance();
      judge_.number(name, is_turn ? said : truth, tolerance());
    }
  }

  /// Of a stroke or a swing.
  double tolerance() const {
    const double unit = loop_.slides() ? loop_.crank + loop_.coupler : 60;
    if (nearness_ == 0 || !near_tie_) return kTolerance;
    const bool is_four_bar = loop_.type == LoopType::four_bar;
    if (!is_four_bar || loop_.tie != Tie::none) return kOfRoots * unit;
    return kTolerance + kOfPlace / nearness_;
  }

  void check_transmission() {
    const double least = truth_.least_transmission, greatest = truth_.greatest_transmission;
    const double acute = std::min(least, 180 - greatest);
    if (loop_.type == LoopType::four_bar) {
      judge_.number("transmission_angle_deg.min", least, kTolerance);
      judge_.number("transmission_angle_deg.max", greatest, kTolerance);
    }
    if (loop_.type == LoopType::four_bar || is_slider_crank() || is_guide()) {
      judge_.number("transmission_angle_deg.acute_min", acute, kTolerance);
    }
    if (is_slider_crank() || is_guide()) {
      judge_.number("pressure_angle_max_deg", 90 - acute, kTolerance);
    }
  }

  const SingleLoop& loop_;
  bool near_tie_;
  double nearness_;
  LoopTruth truth_;
  RangeTally& tally_;
  RangeJudge judge_;
};

}  // namespace

RangeTally check_loops(std::uint64_t seed, int count) {
  RangeTally tally;
  LoopCases cases(seed);
  for (int i = 0; i < count; ++i) {
    const LoopCase drawn = cases.next();
    LoopCheck(drawn, tally).run();
  }
  return tally;
}

}  // namespace cognate::stress
