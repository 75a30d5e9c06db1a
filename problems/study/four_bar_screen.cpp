#include "problems/study/four_bar_screen.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/names.hpp"

namespace cognate::problems {
namespace {

constexpr double kSlack = 1e-9;
constexpr double kLeast = 1e-6, kGreatest = 1e6;  ///< of common lengths

/// cos of an angle that is cut off at 0 and π.
double cosine(double degrees) {
  return std::cos(std::clamp(degrees * (kPi / 180), 0.0, kPi));
}

bool allows(const StudyFilter& filter, std::string_view word) {
  return filter.words.empty() || std::ranges::find(filter.words, word) != filter.words.end();
}

}  // namespace

bool is_common(const FourBar& linkage) {
  const auto is_length = [](double x) { return x >= kLeast && x <= kGreatest; };
  const auto is_place = [](double x) {
    return x == 0 || (std::abs(x) >= 1e-30 && std::abs(x) <= kGreatest);
  };
  const Vec2d point = linkage.coupler_point.value_or(Vec2d{});
  return is_length(linkage.crank) && is_length(linkage.coupler) && is_length(linkage.rocker) &&
         is_length(norm(linkage.pivot_d - linkage.pivot_a)) && is_place(linkage.pivot_a.x) &&
         is_place(linkage.pivot_a.y) && is_place(linkage.pivot_d.x) &&
         is_place(linkage.pivot_d.y) && is_place(point.x) && is_place(point.y);
}

FourBarScreen::FourBarScreen(std::span<const FourBarFilter> filters) {
  for (const FourBarFilter& filter : filters) add(filter);
}

void FourBarScreen::add(const FourBarFilter& filter) {
  const StudyFilter& limits = *filter.limits;
  // Bounds on an angle as bounds on its cosine.
  const auto bound = [&](Cosines& cosines) {
    cosines.least = std::max(cosines.least, limits.max >= 180 ? -2 : cosine(limits.max) - kSlack);
    cosines.greatest =
        std::min(cosines.greatest, limits.min <= 0 ? 2 : cosine(limits.min) + kSlack);
    by_transmission_ = true;
  };
  switch (filter.quantity.quantity) {
    case FourBarQuantityId::varied:
      varied_.push_back({filter.quantity.variable, limits.min, limits.max});
      break;
    case FourBarQuantityId::mobility_class:
      for (const auto& [name, value] : names<MobilityClass>()) {
        if (!allows(limits, name)) allowed_[static_cast<std::size_t>(value)] = 0;
      }
      by_class_ = true;
      break;
    case FourBarQuantityId::crank_turns_fully:
      for (const auto value : {MobilityClass::crank_rocker, MobilityClass::double_crank}) {
        if (!allows(limits, "true")) allowed_[static_cast<std::size_t>(value)] = 0;
      }
      for (const auto value : {MobilityClass::rocker_crank, MobilityClass::double_rocker,
                               MobilityClass::triple_rocker}) {
        if (!allows(limits, "false")) allowed_[static_cast<std::size_t>(value)] = 0;
      }
      by_class_ = true;
      break;
    case FourBarQuantityId::transmission_min:
      bound(least_);
      break;
    case FourBarQuantityId::transmission_max:
      bound(greatest_);
      break;
    case FourBarQuantityId::transmission_acute_min:
      bound(acute_);
      break;
    case FourBarQuantityId::time_ratio:
      // The shorter turn between the limits is 2π/(1 + K), at most half a turn.
      advance_ = {limits.min > 1 ? std::cos(kTurn / (1 + limits.min)) - kSlack : -2,
                  std::cos(kTurn / (1 + std::max(limits.max, 1.0))) + kSlack};
      by_time_ratio_ = true;
      break;
    default:
      break;
  }
}

void FourBarScreen::operator()(const FourBarDesigns& designs, std::span<const double> values,
                               std::size_t variables, std::span<double> stays) {
  std::ranges::fill(stays, 1.0);
  if (!varied_.empty()) screen_varied(values, variables, stays);
  if (by_class_) screen_class(designs, stays);
  if (by_transmission_) screen_transmission(designs, stays);
  if (by_time_ratio_) screen_time_ratio(designs, stays);
}

void FourBarScreen::screen_varied(std::span<const double> values, std::size_t variables,
                                  std::span<double> stays) const {
  for (const auto& [variable, min, max] : varied_) {
    for (std::size_t i = 0; i < stays.size(); ++i) {
      const double value = values[i * variables + variable];
      stays[i] = value >= min && value <= max ? stays[i] : 0.0;
    }
  }
}

namespace {

/// The lengths of the designs as plain arrays, and whether all four of one are common.
struct LengthColumns {
  const double *crank, *coupler, *rocker, *frame;

  explicit LengthColumns(const FourBarDesigns& designs)
      : crank(designs.of(DesignVariable::crank).data()),
        coupler(designs.of(DesignVariable::coupler).data()),
        rocker(designs.of(DesignVariable::rocker).data()),
        frame(designs.frame().data()) {}

  static bool are_common(double least, double greatest) {
    return least >= kLeast && greatest <= kGreatest;
  }
};

}  // namespace

void FourBarScreen::screen_class(const FourBarDesigns& designs, std::span<double> stays) const {
  const auto [crank, coupler, rocker, frame] = LengthColumns(designs);
  const auto [crank_rocker, double_crank, rocker_crank, double_rocker, triple_rocker] = allowed_;
  double* const stay = stays.data();
  for (std::size_t i = 0; i < stays.size(); ++i) {
    const double l1 = crank[i], l2 = coupler[i], l3 = rocker[i], l4 = frame[i];
    const double least = std::min(std::min(l1, l2), std::min(l3, l4));
    const double most = std::max(std::max(l1, l2), std::max(l3, l4));
    const double excess = 2 * (least + most) - (l1 + l2 + l3 + l4);
    const double turning = l1 == least   ? crank_rocker
                           : l4 == least ? double_crank
                           : l3 == least ? rocker_crank
                                         : double_rocker;
    const double allowed = excess < 0 ? turning : triple_rocker;
    const bool is_sure = LengthColumns::are_common(least, most) && std::abs(excess) > 1e-6 * most;
    stay[i] = is_sure ? std::min(stay[i], allowed) : stay[i];
  }
}

void FourBarScreen::screen_transmission(const FourBarDesigns& designs,
                                        std::span<double> stays) const {
  const auto [crank, coupler, rocker, frame] = LengthColumns(designs);
  const Cosines small = least_, great = greatest_, acute = acute_;
  double* const stay = stays.data();
  for (std::size_t i = 0; i < stays.size(); ++i) {
    const double l1 = crank[i], l2 = coupler[i], l3 = rocker[i], l4 = frame[i];
    const double least = std::min(std::min(l1, l2), std::min(l3, l4));
    const double most = std::max(std::max(l1, l2), std::max(l3, l4));
    const double near = std::max(std::abs(l4 - l1), std::abs(l2 - l3));
    const double far = std::min(l4 + l1, l2 + l3);
    const double inverse = 0.5 / (l2 * l3), squares = l2 * l2 + l3 * l3;
    // cos μ by the diagonal's least and greatest.
    const double open = (squares - near * near) * inverse;
    const double closed = (squares - far * far) * inverse;
    const double sharp = std::max(open, -closed);
    const bool inside = open >= small.least && open <= small.greatest && closed >= great.least &&
                        closed <= great.greatest && sharp >= acute.least &&
                        sharp <= acute.greatest && near <= far * (1 + kSlack);
    // Rounding of a cosine grows with the ratio of the lengths.
    const bool is_sure = LengthColumns::are_common(least, most) && most <= 1e3 * least;
    stay[i] = is_sure && !inside ? 0.0 : stay[i];
  }
}

void FourBarScreen::screen_time_ratio(const FourBarDesigns& designs,
                                      std::span<double> stays) const {
  const auto [crank, coupler, rocker, frame] = LengthColumns(designs);
  const Cosines bounds = advance_;
  double* const stay = stays.data();
  for (std::size_t i = 0; i < stays.size(); ++i) {
    const double l1 = crank[i], l2 = coupler[i], l3 = rocker[i], l4 = frame[i];
    const double least = std::min(std::min(l1, l2), std::min(l3, l4));
    const double most = std::max(std::max(l1, l2), std::max(l3, l4));
    // The angles at A of the triangles A–C–D with |AC| = l₂ + l₁ and |l₂ − l₁|.
    const double outer = l2 + l1, inner = l2 - l1;
    const double common = l4 * l4 - l3 * l3;
    const double cos_outer = (common + outer * outer) / (2 * l4 * outer);
    const double cos_inner = (common + inner * inner) / (2 * l4 * inner);
    const double sin_outer = std::sqrt(std::max(1 - cos_outer * cos_outer, 0.0));
    const double sin_inner = std::sqrt(std::max(1 - cos_inner * cos_inner, 0.0));
    // `inner` has the sign that decides whether the crank is turned on by half a turn there.
    const double advance = -cos_outer * cos_inner - sin_outer * sin_inner;
    const bool inside = advance >= bounds.least && advance <= bounds.greatest;
    const bool is_sure = LengthColumns::are_common(least, most) && most <= 1e3 * least &&
                         std::abs(inner) >= 1e-2 * most && std::min(sin_outer, sin_inner) >= 1e-4;
    stay[i] = is_sure && !inside ? 0.0 : stay[i];
  }
}

}  // namespace cognate::problems
