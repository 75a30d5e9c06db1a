/// Second derivatives of the path model.
#include <algorithm>
#include <cmath>

#include "analysis/numbers/angle.hpp"
#include "problems/path/model.hpp"
#include "synthesis/optimise/closure_hessian.hpp"

namespace cognate::problems {
namespace {

/// What the coupler point depends on: the six dimensions of the linkage, named as those of the
/// model, the crank's angle from the frame and the frame's own.
enum Parameter { crank_angle = 6, frame_turn, parameter_count };
using PointHessian = std::array<std::array<double, parameter_count>, parameter_count>;

}  // namespace

/// Of weight · (turn · m), m the point from the anchor in the frame's axes: with γ = weight/turn
/// the second derivatives of γ · m, where turning m is a derivative too.
struct PathModel::PointCurvature {
  Lengths<double> links;
  double u, v;
  double along_frame;  ///< from the anchor to A, in frames: 0 or −1

  PointHessian at(const CrankDirection<double>& direction, const LinkDirections<double>& closure,
                  const Vec2d& gamma) const {
    const Vec2d e1{direction.cos, direction.sin}, e2 = closure.coupler;
    const auto slope = closure_gradient(links, e1, closure).coupler;
    const auto second = synthesis::closure_hessian(links, e1, closure).coupler;
    const std::array<int, 5> of_angle{crank, coupler, rocker, frame, crank_angle};
    const std::array<double, 5> phi{slope.crank, slope.coupler, slope.rocker, slope.frame,
                                    slope.crank_angle};
    const Vec2d q = e2 * Vec2d{u, v};

    PointHessian out{};
    std::array<Vec2d, frame_turn> first{};
    for (int i = 0; i < 5; ++i) {
      first[of_angle[i]] = phi[i] * perp(q);
      for (int j = 0; j < 5; ++j) {
        out[of_angle[i]][of_angle[j]] = dot(gamma, second[i][j] * perp(q) - (phi[i] * phi[j]) * q);
      }
      const double by_u = dot(gamma, phi[i] * perp(e2)), by_v = -dot(gamma, phi[i] * e2);
      out[of_angle[i]][point_u] = out[point_u][of_angle[i]] = by_u;
      out[of_angle[i]][point_v] = out[point_v][of_angle[i]] = by_v;
    }
    out[crank][crank_angle] += dot(gamma, perp(e1));
    out[crank_angle][crank] += dot(gamma, perp(e1));
    out[crank_angle][crank_angle] -= dot(gamma, links.crank * e1);

    first[crank] = first[crank] + e1;
    first[frame].x += along_frame;
    first[crank_angle] = first[crank_angle] + links.crank * perp(e1);
    first[point_u] = e2;
    first[point_v] = perp(e2);
    for (int i = 0; i < frame_turn; ++i)
      out[i][frame_turn] = out[frame_turn][i] = dot(gamma, perp(first[i]));
    const Vec2d arm = Vec2d{along_frame * links.frame, 0} + links.crank * e1 + q;
    out[frame_turn][frame_turn] = -dot(gamma, arm);
    return out;
  }
};

bool PathModel::lagrangian_hessian(std::span<const double> x, std::span<const double> of_residuals,
                                   std::span<const double> of_constraints,
                                   std::span<double> out) const {
  constexpr int kLocal = dimensions;
  const Full v = full(x);
  const Lengths<double> links{v[crank], v[coupler], v[rocker], v[frame]};
  const Closure<double> closure(links);
  const Vec2d turn = unit_vector(v[angle]);
  const Vec2d offset_half = unit_vector(0.5 * timing_offset(v));
  const bool global = problem_.crank_reference == CrankReference::global;
  const PointCurvature curvature{links, v[point_u], v[point_v], anchor_is_d_ ? -1.0 : 0.0};

  // How the parameters of a point follow from the dimensions.
  struct Term {
    int parameter, dimension;
    double slope;
  };
  std::vector<Term> of_free{{crank_angle, kLocal, 1}, {frame_turn, angle, 1}};
  std::vector<Term> of_timed{{crank_angle, phase, 1}, {frame_turn, angle, 1}};
  if (global) of_timed.push_back({crank_angle, angle, -1});
  for (std::vector<Term>* terms : {&of_free, &of_timed}) {
    for (int i = crank; i <= point_v; ++i) terms->push_back({i, i, 1});
  }

  std::vector<int> column(dimensions + 1, -1);
  for (std::size_t i = 0; i < free_.size(); ++i) column[free_[i]] = static_cast<int>(i);
  const std::size_t n = variables_.size();
  std::fill(out.begin(), out.end(), 0.0);
  const auto add = [&](int row, int col, double value) {
    if (column[row] >= 0 && column[col] >= 0) out[column[row] * n + column[col]] += value;
  };

  for (std::size_t j = 0; j < problem_.points.size(); ++j) {
    const auto direction = is_timed(j) ? crank_direction(increment_half_[j] * offset_half)
                                       : crank_direction(local_angle(x, j));
    const auto at = closure.at(direction, assembly_);
    if (!(at.discriminant > 0)) return false;
    const Vec2d weight = root_weight_[j] * Vec2d{of_residuals[2 * j], of_residuals[2 * j + 1]};
    const PointHessian hessian = curvature.at(direction, at, conj(turn) * weight);
    if (!is_timed(j)) column[kLocal] = static_cast<int>(free_.size()) + local_[j];
    const std::vector<Term>& terms = is_timed(j) ? of_timed : of_free;
    for (const Term& a : terms) {
      for (const Term& b : terms) {
        add(a.dimension, b.dimension, a.slope * b.slope * hessian[a.parameter][b.parameter]);
      }
    }
  }

  std::array<double, 16> of_links{};
  linkage_constraints_.add_hessian(links, of_constraints, of_links);
  for (int i = 0; i < 16; ++i) add(i / 4, i % 4, of_links[i]);
  if (driven_range_.count() > 0) {
    std::array<double, 25> of_range{};
    const auto first = static_cast<std::size_t>(linkage_constraints_.count() + pivot_limits());
    driven_range_.add_hessian({links, timing_offset(v)}, of_constraints.subspan(first), of_range);
    const std::array<int, 5> dimension{crank, coupler, rocker, frame, global ? angle : phase};
    const auto sense = [&](int i) { return global && i == 4 ? -1.0 : 1.0; };
    for (int i = 0; i < 5; ++i) {
      for (int j = 0; j < 5; ++j) {
        add(dimension[i], dimension[j], sense(i) * sense(j) * of_range[5 * i + j]);
      }
    }
  }
  const Vec2d pull = pivot_pull(of_constraints);
  const double away = anchor_is_d_ ? -1 : 1;
  const double by_frame = away * dot(pull, perp(turn));
  add(frame, angle, by_frame);
  add(angle, frame, by_frame);
  add(angle, angle, -away * v[frame] * dot(pull, turn));
  return std::all_of(out.begin(), out.end(), [](double value) { return std::isfinite(value); });
}

/// The weights of the other pivot's limits as a force on it.
Vec2d PathModel::pivot_pull(std::span<const double> of_constraints) const {
  Vec2d pull{};
  auto row = static_cast<std::size_t>(linkage_constraints_.count());
  const auto add = [&](double bound, double toward, double Vec2d::*axis) {
    if (std::isfinite(bound)) pull.*axis += toward * of_constraints[row++];
  };
  add(other_pivot_box_.min.x, 1, &Vec2d::x);
  add(other_pivot_box_.max.x, -1, &Vec2d::x);
  add(other_pivot_box_.min.y, 1, &Vec2d::y);
  add(other_pivot_box_.max.y, -1, &Vec2d::y);
  return pull;
}

}  // namespace cognate::problems
