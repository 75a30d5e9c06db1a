#include "synthesis/exact/straight_line/contact_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate::synthesis {
namespace {

using Values = std::array<double, 3>;

/// What vanishes along a family where Ball's point may have contact of five points: P₁ × P₄ and P₁
/// × P₅ there, and the coupler's angular velocity, without which all of a line may have its
/// contact.
class BallContact {
 public:
  explicit BallContact(const LinkageFamily& family) : family_(family) {}

  /// The first two are not numbers where Ball's point is not one point.
  Values at(double parameter) const {
    const auto member = family_(parameter);
    if (!member) return {kNaN, kNaN, kNaN};
    const auto position = coupler_position(member->linkage, member->crank_angle);
    if (!position) return {kNaN, kNaN, kNaN};
    const double turn = cross(position->series.direction[0], position->series.direction[1]);
    const auto four = four_point_contact(position->series, position->size);
    if (four.kind != FourPointContact::Kind::point) return {kNaN, kNaN, turn};
    // The coordinates are homogeneous and known but for their sign: even powers of them alone.
    const double area = position->size * position->size;
    return {contact_value(position->series, 4, four.ball) / area,
            contact_value(position->series, 5, four.ball) / area, turn};
  }

  std::vector<StraightLineSolution> solutions(double parameter) const {
    std::vector<StraightLineSolution> found;
    const auto member = family_(parameter);
    if (!member) return found;
    for (const auto& point : straight_points(member->linkage, member->crank_angle, 5).points) {
      found.push_back({member->linkage, member->crank_angle, point});
    }
    return found;
  }

 private:
  const LinkageFamily& family_;
};

/// Zeros of P₁ × P₄ along a family from samples of it.
class ZeroSearch {
 public:
  ZeroSearch(const BallContact& contact, double from, double to)
      : contact_(contact), from_(from), step_((to - from) / kCells) {
    for (int k = 0; k <= kCells; ++k) samples_.push_back(contact.at(place(k)));
  }

  std::vector<double> zeros() const {
    std::vector<double> found;
    for (int k = 0; k < kCells; ++k) {
      const auto &before = sample(k), &after = sample(k + 1);
      if (before[0] == 0) found.push_back(place(k));
      // A place without one Ball's point, where a whole locus may have its contact.
      if (std::isnan(before[0]) && !std::isnan(after[0])) found.push_back(place(k));
      if (std::isnan(after[0]) && !std::isnan(before[0])) found.push_back(place(k + 1));
      if (before[0] * after[0] < 0) found.push_back(crossing<0>(k));
      if (before[1] * after[1] < 0) found.push_back(crossing<1>(k));
      if (before[2] * after[2] < 0) found.push_back(crossing<2>(k));
      if (k > 0 && touches(sample(k - 1)[0], before[0], after[0])) found.push_back(touching(k));
    }
    return found;
  }

 private:
  // Off the round numbers on which change points and symmetric positions are likely to be.
  static constexpr int kCells = 1439;

  double place(int k) const { return from_ + k * step_; }
  const Values& sample(int k) const { return samples_[static_cast<std::size_t>(k)]; }

  /// Where no Ball's point is, a zero for the purpose of bracketing.
  template <std::size_t K>
  double crossing(int k) const {
    const auto f = [this](double q) {
      const double value = contact_.at(q)[K];
      return std::isfinite(value) ? value : 0.0;
    };
    return better_end(f, bracket_zero(f, place(k), sample(k)[K], place(k + 1), sample(k + 1)[K]));
  }

  static bool touches(double before, double here, double after) {
    return before * here > 0 && here * after > 0 && std::abs(here) <= std::abs(before) &&
           std::abs(here) <= std::abs(after);
  }

  /// Next to a double zero the root of the function goes linearly through it.
  double touching(int k) const {
    double zero = place(k);
    for (const double reach : {1.0, 0.1, 1e-2, 1e-3}) {
      const double h = reach * step_;
      const double left = std::sqrt(std::abs(contact_.at(zero - h)[0]));
      const double right = std::sqrt(std::abs(contact_.at(zero + h)[0]));
      const double shift = h * (left - right) / (left + right);
      if (std::isfinite(shift)) zero += shift;
    }
    return zero;
  }

  const BallContact& contact_;
  double from_;
  double step_;
  std::vector<Values> samples_;
};

/// Whether the first of `a` has the higher contact than that of `b`, or the same more closely.
bool is_better(const std::vector<StraightLineSolution>& a,
               const std::vector<StraightLineSolution>& b) {
  if (a.empty() || b.empty()) return b.empty();
  const Contact &x = a.front().point.contact, &y = b.front().point.contact;
  return x.points != y.points ? x.points > y.points : x.residual < y.residual;
}

/// The solutions at `zeros`; of zeros that are one but for rounding, the best.
std::vector<StraightLineSolution> solutions_at(const BallContact& contact,
                                               std::vector<double> zeros, double same) {
  std::ranges::sort(zeros);
  std::vector<StraightLineSolution> all, best;
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    auto found = contact.solutions(zeros[i]);
    if (is_better(found, best)) best = std::move(found);
    if (i + 1 < zeros.size() && zeros[i + 1] - zeros[i] <= same) continue;
    std::ranges::move(best, std::back_inserter(all));
    best.clear();
  }
  return all;
}

/// A turn's end is its beginning, and the ranges of a crank may touch.
void keep_new(std::vector<StraightLineSolution>& all,
              const std::vector<StraightLineSolution>& some) {
  constexpr double kSame = 1e-6;
  const auto is_same = [](const StraightLineSolution& a, const StraightLineSolution& b) {
    const Vec2d difference = a.point.coupler_point - b.point.coupler_point;
    return std::abs(std::sin(0.5 * (a.crank_angle - b.crank_angle))) < kSame &&
           norm(difference) < kSame * norm(a.point.coupler_point);
  };
  for (const auto& next : some) {
    const bool known = std::ranges::any_of(
        all, [&](const StraightLineSolution& other) { return is_same(other, next); });
    if (!known) all.push_back(next);
  }
}

std::vector<StraightLineSolution> limit_positions(const SliderCrank& linkage, int contact) {
  std::vector<StraightLineSolution> found;
  const double slide = std::atan2(linkage.direction.y, linkage.direction.x);
  const double side = linkage.assembly == Assembly::open ? 1 : -1;
  // The pin at the distance l₁ ± l₂ from A along the crank, on the slide line.
  for (const double reach : {linkage.crank + linkage.coupler, linkage.crank - linkage.coupler}) {
    const double sine = linkage.offset / reach;
    if (!(std::abs(sine) <= 1)) continue;
    // The coupler points ahead along the slide for `open`.
    const double ahead = reach > linkage.crank ? side : -side;
    const double angle = ahead > 0 ? std::asin(sine) : std::acos(-1.0) - std::asin(sine);
    for (const auto& point : straight_points(linkage, slide + angle, contact).points) {
      found.push_back({linkage, slide + angle, point});
    }
  }
  return found;
}

/// With the crank across the slide line, where the coupler does not turn.
std::vector<StraightLineSolution> positions_across(const SliderCrank& linkage, int contact) {
  std::vector<StraightLineSolution> found;
  const double slide = std::atan2(linkage.direction.y, linkage.direction.x);
  for (const double side : {1.0, -1.0}) {
    if (!(std::abs(side * linkage.crank - linkage.offset) < linkage.coupler)) continue;
    const double angle = slide + side * kRightAngle;
    for (const auto& point : straight_points(linkage, angle, contact).points) {
      found.push_back({linkage, angle, point});
    }
  }
  return found;
}

/// Of a family by one length, from 1/1000 to 1000 times the longest of the others.
template <class MemberOfLength>
std::vector<StraightLineSolution> over_lengths(double longest, const MemberOfLength& member) {
  const LinkageFamily family = [&](double exponent) {
    return member(longest * std::pow(10.0, exponent));
  };
  return five_point_members(family, -3, 3);
}

}  // namespace

std::vector<StraightLineSolution> five_point_members(const LinkageFamily& family, double from,
                                                     double to) {
  const BallContact contact(family);
  constexpr double kSame = 1e-7;
  return solutions_at(contact, ZeroSearch(contact, from, to).zeros(), kSame * (to - from));
}

std::vector<StraightLineSolution> straight_positions(const CouplerLinkage& linkage, int contact) {
  if (const auto* slider = std::get_if<SliderCrank>(&linkage)) {
    auto found = limit_positions(*slider, contact);
    if (contact < 5) keep_new(found, positions_across(*slider, contact));
    return found;
  }
  if (contact < 5) return {};
  const LinkageFamily positions = [&linkage](double angle) {
    return std::optional(FamilyMember{linkage, angle});
  };
  std::vector<StraightLineSolution> found;
  // Nearer to a change point the derivatives of this order are lost to rounding.
  constexpr double kMargin = 1e-3;
  for (const CrankRange& range : crank_ranges(linkage, kMargin)) {
    keep_new(found, five_point_members(positions, range.from, range.to));
  }
  return found;
}

std::vector<StraightLineSolution> straight_lengths(const FourBar& linkage,
                                                   double Lengths<double>::*length,
                                                   double crank_angle) {
  Lengths<double> links = lengths(linkage);
  const Vec2d frame = (1 / links.frame) * (linkage.pivot_d - linkage.pivot_a);
  links.*length = 0;
  const double longest = std::max({links.crank, links.coupler, links.rocker, links.frame});
  return over_lengths(longest, [&](double value) {
    Lengths<double> tried = links;
    tried.*length = value;
    const Vec2d d = linkage.pivot_a + tried.frame * frame;
    const FourBar member{linkage.pivot_a,  d, tried.crank, tried.coupler, tried.rocker,
                         linkage.assembly, {}};
    return std::optional(FamilyMember{member, crank_angle});
  });
}

std::optional<FamilyMember> symmetric_position(double crank, double coupler, double frame,
                                               Assembly assembly) {
  const double across = 0.5 * (assembly == Assembly::open ? frame - coupler : frame + coupler);
  const double square = (crank - across) * (crank + across);
  if (!(square > 0)) return std::nullopt;
  const FourBar linkage{{}, {frame, 0}, crank, coupler, crank, assembly, {}};
  return FamilyMember{linkage, std::atan2(std::sqrt(square), across)};
}

std::vector<StraightLineSolution> symmetric_lengths(double crank, double coupler, double frame,
                                                    Assembly assembly,
                                                    double Lengths<double>::*length) {
  Lengths<double> links{crank, coupler, 0, frame};
  links.*length = 0;
  return over_lengths(std::max({links.crank, links.coupler, links.frame}), [&](double value) {
    Lengths<double> tried = links;
    tried.*length = value;
    return symmetric_position(tried.crank, tried.coupler, tried.frame, assembly);
  });
}

}  // namespace cognate::synthesis
