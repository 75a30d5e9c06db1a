/// @file The circuits of a four-bar as closed curves, dead points of the crank included.
///
/// The crank angle is no parameter of a motion that turns back at dead points: positions go with
/// the root of its distance from there. So a circuit is a chain of arcs, by the crank's angle θ
/// from A→D where the transmission angle μ = ∠BCD changes well, and by μ, counted on beyond 0 and π
/// to the other assembly, next to dead points. Either triangle, A–B–D and B–C–D, follows from the
/// diagonal B–D with products of sums of lengths, so that neither end loses digits.
#pragma once

#include <vector>

#include "analysis/linkage/closure.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/motion_state.hpp"

namespace cognate {

/// Unit vectors along A→B, B→C and D→C, in the frame's axes (x along A→D).
struct LinkPose {
  Vec2d crank;
  Vec2d coupler;
  Vec2d rocker;
};

/// A piece of a circuit, by θ or by the signed μ (in (0, π) where the assembly is open), `from` <
/// `to`.
struct CircuitArc {
  /// What the arc is parametrised by.
  enum class By { crank, transmission };
  By by = By::crank;
  double from = 0;
  double to = 0;
  double sign = 1;  ///< by the crank: of the assembly; by transmission: of sin θ
  int circuit = 0;
};

/// The circuits of a linkage whose lengths are in a unit near the longest. Two circuits where the
/// crank turns fully, one for each assembly, and where it has two ranges; else one; none where it
/// cannot be assembled. At a change point circuits meet; each is here as if it had none.
class Circuits {
 public:
  /// The circuits of these lengths.
  explicit Circuits(const Lengths<double>& links);

  /// The arcs of all circuits that are kept.
  const std::vector<CircuitArc>& arcs() const { return arcs_; }

  /// Leaves out the arcs of all circuits but one.
  void keep(int circuit);

  /// The links' directions at a place of an arc.
  LinkPose at(const CircuitArc& arc, double place) const;

 private:
  void add_range(double from, double to, int circuit);
  ClosureTriangle<double> triangle(double crank_angle) const;
  LinkPose by_crank(double crank_angle, double side) const;
  LinkPose by_transmission(double angle, double sign) const;

  Lengths<double> links_;
  HalfClosure<double> near_, far_;
  std::vector<CircuitArc> arcs_;
};

/// The coupler's motion in the frame's axes, with A as the origin, by a parameter τ that no dead
/// point of any link stops: l₁ dθ/dτ, l₂ dφ/dτ and −l₃ dψ/dτ are the sines between the other two
/// links. Only at a change point, where all links are in line, do all derivatives vanish.
BodyMotion<double, 3> coupler_motion(const Lengths<double>& links, const LinkPose& pose);

}  // namespace cognate
