/// Curvatures and velocities of the kernel against differences of positions alone, in 113 bits.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "analysis/cam/quantity.hpp"
#include "tests/support/cam_problems.hpp"

namespace cognate::cam_curvature_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using problems::CamProblem;

template <class T>
cam::MotionPiece<Quad> widened(const cam::MotionPiece<T>& piece) {
  cam::MotionPiece<Quad> wide;
  wide.begin = piece.begin;
  wide.span = piece.span;
  wide.offset = piece.offset;
  wide.scale = piece.scale;
  for (std::size_t k = 0; k < piece.polynomial.size(); ++k) {
    wide.polynomial[k] = piece.polynomial[k];
  }
  for (std::size_t k = 0; k < piece.sinusoids.size(); ++k) {
    const auto& wave = piece.sinusoids[k];
    wide.sinusoids[k] = {wave.amplitude, wave.rate, wave.phase};
  }
  wide.terms = piece.terms;
  wide.sinusoid_count = piece.sinusoid_count;
  return wide;
}

cam::CamFollower<Quad> widened(const cam::CamFollower<double>& follower) {
  const auto& d = follower.dimensions;
  return {follower.type,
          follower.side,
          {d.base_radius, d.offset, d.roller_radius, d.centre_distance, d.arm, d.face_offset}};
}

/// A point of the pitch curve (of a flat face's profile) in the cam's axes at the share t of a
/// piece, from positions only. A flat face's is where its line meets the next one's.
class Curve {
 public:
  Curve(const cam::CamFollower<double>& follower, const cam::MotionPiece<double>& piece)
      : follower_(widened(follower)), start_(starting_place(follower_)), piece_(widened(piece)) {}

  Vec2<Quad> at(const Quad& t) const {
    const auto m = motion_at(piece_, t);
    const Quad angle = piece_.begin + t * piece_.span;
    const Vec2<Quad> direction{cos(angle), sin(angle)};
    return cam::in_cam(roller_state(follower_, start_, m).centre, direction);
  }

  /// Normal and distance of the face's line.
  std::pair<Vec2<Quad>, Quad> face(const Quad& t) const {
    const auto m = motion_at(piece_, t);
    const Quad angle = piece_.begin + t * piece_.span;
    const auto state = face_state(follower_, start_, m);
    const Vec2<Quad> normal = cam::in_cam(state.normal, {cos(angle), sin(angle)});
    return {normal, dot(state.contact, state.normal)};
  }

 private:
  cam::CamFollower<Quad> follower_;
  Quad start_;
  cam::MotionPiece<Quad> piece_;
};

/// The circle through three near points, positive where the curve bends clockwise.
Quad menger(const Vec2<Quad>& a, const Vec2<Quad>& b, const Vec2<Quad>& c) {
  const auto length = [](const Vec2<Quad>& v) { return sqrt(squared_norm(v)); };
  return Quad(-2) * cross(b - a, c - b) / (length(b - a) * length(c - b) * length(c - a));
}

/// To the fourth order in the step.
Quad curvature(const Curve& curve, double t) {
  const auto with = [&](double step) {
    return menger(curve.at(Quad(t) - step), curve.at(Quad(t)), curve.at(Quad(t) + step));
  };
  constexpr double kStep = 1e-5;
  return (4 * with(0.5 * kStep) - with(kStep)) / 3;
}

/// Where the lines before and after meet is on the curve to second order; the radius is the way of
/// that point over the turn of the normal.
Quad radius(const Curve& curve, double t) {
  const auto meet = [&](const Quad& s) {
    const Quad step = 1e-9;
    const auto [n, h] = curve.face(s - step);
    const auto [m, k] = curve.face(s + step);
    const Quad determinant = cross(n, m);
    return Vec2<Quad>{(h * m.y - k * n.y) / determinant, (k * n.x - h * m.x) / determinant};
  };
  const auto with = [&](double step) {
    const Quad a = Quad(t) - step, b = Quad(t) + step;
    const auto n = curve.face(a).first, m = curve.face(b).first;
    const Vec2<Quad> way = meet(b) - meet(a);
    const Quad turn = atan2(cross(n, m), dot(n, m));
    const Vec2<Quad> between = n + m;
    // Along the face, clockwise as the normal turns.
    return cross(way, between) / sqrt(squared_norm(between)) / -turn;
  };
  constexpr double kStep = 1e-4;
  return (4 * with(0.5 * kStep) - with(kStep)) / 3;
}

void compare(CamProblem problem, std::mt19937_64& random, double stroke) {
  problem.motion = random_motion(random, stroke);
  const auto cam = solve(problem, {.threads = 1}).designs.at(0).cam;
  for (const auto& piece : cam.programme.pieces()) {
    const Curve curve(cam.system.follower, piece);
    for (const double t : {0.11, 0.37, 0.5, 0.83}) {
      const auto m = motion_at(piece, t);
      if (is_flat(problem.follower)) {
        const double found = value_of(cam::CamQuantity::face_radius, cam.system, m);
        EXPECT_NEAR(found, double(radius(curve, t)), 1e-11 * 100);
      } else {
        const double found = value_of(cam::CamQuantity::pitch_curvature, cam.system, m);
        EXPECT_NEAR(found, double(curvature(curve, t)), 1e-13);
      }
    }
  }
}

TEST(CamCurvature, OfRollersIsThatOfThePitchCurve) {
  std::mt19937_64 random(51);
  for (int i = 0; i < 4; ++i) {
    compare(translating_roller(50, 11 - 7 * i, 5), random, 20);
    CamProblem arm = oscillating_roller(40, 80, 60, 5);
    arm.side = i % 2 == 0 ? cam::ArmSide::trailing : cam::ArmSide::leading;
    compare(arm, random, 0.3);
  }
}

TEST(CamCurvature, OfFlatFacesIsThatOfTheEnvelopeOfLines) {
  std::mt19937_64 random(52);
  using problems::CamDimension;
  CamProblem problem;
  problem.follower = cam::FollowerType::translating_flat;
  use(problem, CamDimension::base_radius, 60);
  compare(problem, random, 10);
  problem.follower = cam::FollowerType::oscillating_flat;
  use(problem, CamDimension::centre_distance, 120);
  use(problem, CamDimension::face_offset, 6);
  for (const auto side : {cam::ArmSide::trailing, cam::ArmSide::leading}) {
    problem.side = side;
    compare(problem, random, 0.1);
  }
}

}  // namespace
}  // namespace cognate::cam_curvature_test
