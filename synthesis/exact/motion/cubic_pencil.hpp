/// @file A circular cubic of the projective plane, walked on by the lines through its real point at
/// infinity.
///
/// The cubic is det[F₁x, F₂x, F₃x] = 0. A line through its point O at infinity, x = s·O + m with m
/// = cos φ·a + sin φ·b, meets it in two more points: A(φ)s² + B(φ)s + D(φ) = 0. So the cubic is
/// covered in closed form, without steps that could lose it: where B² − 4AD is positive on an
/// interval of φ the two roots make a closed curve, smooth in t with φ = middle − half·cos(2πt).
/// Where it only touches zero the curve has a node, and each root goes on as the other. Where A, B
/// and D have a common root the cubic contains that line, and the rest is a conic.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace cognate::synthesis {

using ThreeForms = std::array<Eigen::Matrix3d, 3>;

/// det[F₁x, F₂x, F₃x] on the line x = X·p + Y·q as a form in (X, Y).
std::array<double, 4> cubic_on_line(const ThreeForms& forms, const Eigen::Vector3d& p,
                                    const Eigen::Vector3d& q);

class CubicPencil {
 public:
  /// Forms whose cubic is circular: it contains the circular points at infinity.
  explicit CubicPencil(const ThreeForms& forms);

  /// Whether every point of the plane is on the cubic; it then has no arcs.
  bool is_everything() const { return is_everything_; }
  /// Whether the line at infinity is a part of the cubic.
  bool has_line_at_infinity() const { return has_line_at_infinity_; }
  /// The real point at infinity, a unit vector; one of many if the line at infinity is a part.
  const Eigen::Vector3d& point_at_infinity() const { return centre_; }

  /// Closed curves that make up the cubic.
  int arc_count() const { return static_cast<int>(arcs_.size()); }
  /// The point of an arc at t (of period 1), a unit vector.
  Eigen::Vector3d at(int arc, double t) const;

 private:
  /// A loop goes there and back between two tangents through O, a sheet on and on in one sense.
  enum class Kind { loop, sheet, line };
  struct Arc {
    Kind kind = Kind::loop;
    double middle = 0, half = 0;  ///< of the range of φ; for a line φ is `middle`
    int sheet = 1;                ///< which root, before the first node
  };

  void find_centre(const ThreeForms& forms);
  void find_coefficients(const ThreeForms& forms);
  void split_off_line();
  void find_arcs();
  void find_sheets();
  Eigen::Vector3d direction(double angle) const;
  int nodes_before(double angle) const;
  Eigen::Vector3d root(double angle, int sheet) const;

  Eigen::Vector3d centre_, across_, along_;
  std::vector<double> a_, b_, d_;  ///< forms in (cos φ, sin φ), of degree 1, 2, 3 or one less
  std::array<double, 5> discriminant_{};
  std::vector<double> nodes_;  ///< φ of the nodes, in [0, π)
  std::vector<Arc> arcs_;
  double size_ = 0;
  bool is_everything_ = false;
  bool has_line_at_infinity_ = false;
};

}  // namespace cognate::synthesis
