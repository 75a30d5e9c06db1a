/// @file Positions, or a dimension, for which Ball's point has contact of five points.
///
/// Along any one-parameter family of positions P₁ × P₄ at Ball's point, as a point of the
/// projective plane, is a continuous function but for its sign's square; contact of five points is
/// where it vanishes. Where linkages are symmetric it touches zero without changing its sign, and
/// P₁ × P₅ changes its own there.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "synthesis/exact/straight_line/straight_points.hpp"

namespace cognate::synthesis {

/// A linkage, the crank angle of its position, and the points that it has there.
struct StraightLineSolution {
  CouplerLinkage linkage;
  double crank_angle = 0;  ///< from the x axis
  StraightPoint point;
};

/// A member of a family of linkages, each at a position.
struct FamilyMember {
  CouplerLinkage linkage;
  double crank_angle = 0;
};

/// The member for a parameter; empty where there is none.
using LinkageFamily = std::function<std::optional<FamilyMember>(double)>;

/// All members for parameters between `from` and `to` whose Ball's point has contact of at least
/// five points; those that lie closer together than (to − from)/1440 may be missed.
std::vector<StraightLineSolution> five_point_members(const LinkageFamily& family, double from,
                                                     double to);

/// All positions of a linkage, in its own assembly, with contact of at least `contact` points, 4 or
/// 5. Of a four-bar contact of five is meant (every position has Ball's point): nothing for 4, and
/// nothing within 0.001 of a change point. Of a slider-crank the points in its two limit positions
/// and, of contact of four, with the crank across the slide line, where the pole is at infinity.
std::vector<StraightLineSolution> straight_positions(const CouplerLinkage& linkage, int contact);

/// The four-bars that differ from `linkage` in one length alone (a frame grows from A along its
/// direction) and have contact of five points at `crank_angle`, in its assembly. That length is
/// sought from 1/1000 to 1000 times the longest of the others.
std::vector<StraightLineSolution> straight_lengths(const FourBar& linkage,
                                                   double Lengths<double>::*length,
                                                   double crank_angle);

/// A four-bar of equal cranks in its symmetric position: coupler and frame parallel, A = (0, 0), D
/// = (frame, 0), B and C above; `open` with B over A's side, `crossed` with the cranks crossing.
/// Empty where the cranks do not reach.
std::optional<FamilyMember> symmetric_position(double crank, double coupler, double frame,
                                               Assembly assembly);

/// The symmetric positions that differ in one length (crank: of both) and have contact of five
/// points, which for reasons of symmetry is one of six. Same range as above.
std::vector<StraightLineSolution> symmetric_lengths(double crank, double coupler, double frame,
                                                    Assembly assembly,
                                                    double Lengths<double>::*length);

}  // namespace cognate::synthesis
