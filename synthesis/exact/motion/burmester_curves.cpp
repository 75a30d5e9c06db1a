#include "synthesis/exact/motion/burmester_curves.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/binary_form.hpp"
#include "synthesis/exact/motion/cubic_pencil.hpp"
#include "synthesis/exact/motion/degenerate_poses.hpp"
#include "synthesis/exact/motion/guidance_forms.hpp"

namespace cognate::synthesis {

/// Which of its pivots a dyad is found by.
enum class PivotSide { fixed, moving };

namespace {

using Eigen::Vector3d;

/// Lines nearer to one another than this (sine of their angle) have no one point in common.
constexpr double kOneLine = 1e-10;
/// Pivots nearer than this, as unit vectors, are one.
constexpr double kSame = 1e-9;
/// Coefficients of a cubic below this are none: the line given is a part of the curve.
constexpr double kCurveVanishes = 1e-14;
/// An arc of this size is a point, if partners farther apart than the other belong to it.
constexpr double kPoint = 1e-6, kManyPartners = 1e-3;
/// Parameters by which an arc is known.
constexpr std::array kSamples{0.07, 0.23, 0.41, 0.61, 0.83};

ThreeForms forms_of(const GuidanceForms& forms, PivotSide side) {
  ThreeForms result;
  for (int j = 0; j < 3; ++j) {
    result[static_cast<std::size_t>(j)] =
        side == PivotSide::fixed ? forms.basis(j) : forms.basis(j).transpose();
  }
  return result;
}

/// The common point of the lines Fⱼx; empty where they are one line (or none).
std::optional<Vector3d> partner(const ThreeForms& forms, const Vector3d& x) {
  const Vector3d a = forms[0] * x, b = forms[1] * x, c = forms[2] * x;
  const std::array<Vector3d, 3> points{a.cross(b), b.cross(c), c.cross(a)};
  const Vector3d& best = *std::ranges::max_element(
      points, {}, [](const Vector3d& point) { return point.squaredNorm(); });
  if (!(best.norm() > kOneLine)) return std::nullopt;
  return best.normalized();
}

PivotPair pair_of(PivotSide side, const Vector3d& x, const Vector3d& other) {
  return side == PivotSide::fixed ? PivotPair{other, x} : PivotPair{x, other};
}

double apart(const Vector3d& a, const Vector3d& b) {
  return std::min((a - b).norm(), (a + b).norm());
}

}  // namespace

/// One of the two curves.
struct PivotCurve {
  PivotSide side;
  ThreeForms forms;
  CubicPencil cubic;

  PivotCurve(const GuidanceForms& all, PivotSide by)
      : side(by), forms(forms_of(all, by)), cubic(forms) {}

  std::optional<PivotPair> pair_at(const Vector3d& x) const {
    const auto other = partner(forms, x);
    if (!other) return std::nullopt;
    return pair_of(side, x, *other);
  }

  /// Whether all points of an arc, a straight line then, belong to one partner. The other curve has
  /// a single point for it.
  bool has_one_partner(int arc) const {
    std::optional<Vector3d> first;
    for (const double t : kSamples) {
      const auto other = partner(forms, cubic.at(arc, t));
      if (!other || (first && apart(*first, *other) > kSame)) return false;
      first = other;
    }
    return true;
  }
  /// Whether an arc is a mere point to which a line of partners belongs: that line is an arc of the
  /// other curve.
  bool is_point_of_many(int arc) const {
    const Vector3d point = cubic.at(arc, kSamples[0]);
    const auto first = partner(forms, point);
    bool has_many = !first;
    for (const double t : kSamples) {
      const Vector3d next = cubic.at(arc, t);
      if (apart(point, next) > kPoint) return false;
      const auto other = partner(forms, next);
      has_many = has_many || !other || apart(*first, *other) > kManyPartners;
    }
    return has_many;
  }
};

struct BurmesterCurves::Data {
  explicit Data(std::span<const Pose, 4> given)
      : poses{given[0], given[1], given[2], given[3]}, forms(poses) {
    if (forms.status() != GuidanceStatus::found) return;
    centres.emplace(forms, PivotSide::fixed);
    circles.emplace(forms, PivotSide::moving);
    for (int arc = 0; arc < centres->cubic.arc_count(); ++arc) {
      if (has_dyads(*centres, arc) && !centres->is_point_of_many(arc))
        branches.push_back({&*centres, arc});
    }
    for (int arc = 0; arc < circles->cubic.arc_count(); ++arc) {
      if (circles->has_one_partner(arc)) branches.push_back({&*circles, arc});
    }
  }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;

  struct Branch {
    const PivotCurve* curve;
    int arc;
  };

  /// Whether an arc is more than pairs of points at infinity.
  bool has_dyads(const PivotCurve& curve, int arc) const {
    return std::ranges::any_of(kSamples, [&](double t) {
      return dyads(std::array{curve.pair_at(curve.cubic.at(arc, t))}).count > 0;
    });
  }
  DyadSolutions dyads(std::span<const std::optional<PivotPair>> pairs) const;
  DyadSolutions at_infinity(const PivotCurve& curve) const;
  DyadSolutions on_line(const PivotCurve& curve, const std::array<Vector3d, 2>& line) const;

  std::array<Pose, 4> poses;
  GuidanceForms forms;
  std::optional<PivotCurve> centres, circles;
  std::vector<Branch> branches;
};

/// Found where there is a partner for each, none where both pivots are at infinity, `family` where
/// one has many. A double point counts once.
DyadSolutions BurmesterCurves::Data::dyads(std::span<const std::optional<PivotPair>> pairs) const {
  DyadSolutions result{pairs.empty() ? GuidanceStatus::none : GuidanceStatus::found, {}, 0};
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!pairs[k]) {
      result.status = GuidanceStatus::family;
    } else if (std::ranges::none_of(pairs.first(k), [&](const auto& before) {
                 return before && apart(before->moving, pairs[k]->moving) <= kSame &&
                        apart(before->fixed, pairs[k]->fixed) <= kSame;
               })) {
      if (const auto dyad = forms.dyad(forms.refined(*pairs[k]))) result.add(*dyad);
    }
  }
  if (result.status == GuidanceStatus::found && result.count == 0) {
    result.status = GuidanceStatus::none;
  }
  return result;
}

DyadSolutions BurmesterCurves::Data::at_infinity(const PivotCurve& curve) const {
  if (!curve.cubic.has_line_at_infinity()) {
    return dyads(std::array{curve.pair_at(curve.cubic.point_at_infinity())});
  }
  std::array<std::optional<PivotPair>, 4> pairs;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double angle = 0.25 * kPi * static_cast<double>(k);
    pairs[k] = curve.pair_at(Vector3d(std::cos(angle), std::sin(angle), 0));
  }
  DyadSolutions result = dyads(pairs);
  if (result.count > 0) result.status = GuidanceStatus::family;
  return result;
}

DyadSolutions BurmesterCurves::Data::on_line(const PivotCurve& curve,
                                             const std::array<Vector3d, 2>& line) const {
  const auto cubic = cubic_on_line(curve.forms, line[0], line[1]);
  const bool contained =
      std::ranges::all_of(cubic, [](double c) { return std::abs(c) <= kCurveVanishes; });
  if (contained) return {GuidanceStatus::same_line, {}, 0};
  std::vector<std::optional<PivotPair>> pairs;
  for (const Vec2d& root : real_roots(cubic)) {
    if (std::abs(root.x) <= kSame) continue;  // at infinity, where all parallel lines meet
    pairs.push_back(curve.pair_at((root.x * line[0] + root.y * line[1]).normalized()));
  }
  return dyads(pairs);
}

BurmesterCurves::BurmesterCurves(std::span<const Pose, 4> poses)
    : data_(std::make_shared<const Data>(poses)) {
  status_ = data_->forms.status();
  if (status_ == GuidanceStatus::found) status_ = GuidanceStatus::family;
}

int BurmesterCurves::branch_count() const {
  return static_cast<int>(data_->branches.size());
}

DyadSolutions BurmesterCurves::at(int branch, double parameter) const {
  const Data::Branch& curve = data_->branches[static_cast<std::size_t>(branch)];
  return data_->dyads(
      std::array{curve.curve->pair_at(curve.curve->cubic.at(curve.arc, parameter))});
}

DyadSolutions BurmesterCurves::sliders() const {
  return data_->centres ? data_->at_infinity(*data_->centres) : DyadSolutions{status_, {}, 0};
}

DyadSolutions BurmesterCurves::blocks() const {
  return data_->circles ? data_->at_infinity(*data_->circles) : DyadSolutions{status_, {}, 0};
}

BurmesterCurves::Window BurmesterCurves::window() const {
  const double size = extent(data_->poses);
  return {data_->poses[0].at, size > 0 ? size : 1.0};
}

DyadSolutions BurmesterCurves::examples() const {
  return degenerate_dyads(data_->poses, status_);
}

DyadSolutions BurmesterCurves::with_fixed_pivot_on(const Line& line) const {
  if (!data_->centres) return {status_, {}, 0};
  return data_->on_line(*data_->centres, data_->forms.fixed_line(line));
}

DyadSolutions BurmesterCurves::with_moving_pivot_on(const Line& line) const {
  if (!data_->circles) return {status_, {}, 0};
  return data_->on_line(*data_->circles, data_->forms.moving_line(line));
}

}  // namespace cognate::synthesis
