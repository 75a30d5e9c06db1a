#include "analysis/cam/motion_law.hpp"

#include "analysis/cam/polynomial_law.hpp"
#include "analysis/cam/spline_law.hpp"
#include "analysis/cam/universal_law.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::cam {
namespace {

using Piece = MotionPiece<double>;

Piece whole(std::initializer_list<double> polynomial,
            std::initializer_list<Sinusoid<double>> sinusoids = {}) {
  return unit_piece<double>(0, 1, polynomial, sinusoids);
}

/// (1 − cos πu)/2 − (1 − cos 2πu)/8: at rest and without acceleration at the bottom, where the
/// follower dwells, but not at the top, where the return follows at once. Rothbart, Cams, 1956.
Piece double_harmonic(bool is_return) {
  const Piece up = whole({0.375}, {{-0.5, 1, 0.5}, {0.125, 2, 0.5}});
  return is_return ? mirrored(up) : up;
}

void append_halves(const Piece& first, const Place<double>& place, std::vector<Piece>& pieces) {
  pieces.push_back(placed(first, place));
  pieces.push_back(placed(mirrored(first), place));
}

void append_universal(const UniversalShape<double>& shape, const Place<double>& place,
                      std::vector<Piece>& pieces) {
  append_universal<double>(shape, place.begin, place.over, place.start, place.rise, place.segment,
                           pieces);
}

/// Whether the shares are shares of 1, to rounding.
bool is_valid(const UniversalShape<double>& shape) {
  return shape.sine >= 0 && shape.constant >= 0 && shape.cosine >= 0 &&
         shape.sine + shape.constant + shape.cosine <= 1 + kLeastShare;
}

}  // namespace

bool append_pieces(const MotionSegment& segment, double begin, double start, int index,
                   std::vector<Piece>& pieces) {
  const Place<double> place{begin, segment.over, start, segment.rise, index};
  const auto append = [&](const Piece& piece) { pieces.push_back(placed(piece, place)); };
  switch (segment.law) {
    case MotionLaw::dwell:
      append(whole({}));
      return true;
    case MotionLaw::constant_velocity:
      append(whole({0.5, 0.5}));
      return true;
    case MotionLaw::constant_acceleration:
      append_halves(unit_piece<double>(0, 0.5, {0.125, 0.25, 0.125}), place, pieces);
      return true;
    case MotionLaw::harmonic:
      append(whole({0.5}, {{-0.5, 1, 0.5}}));
      return true;
    case MotionLaw::cycloidal:
      append(whole({0.5, 0.5}, {{-0.5 / pi_of<double>(), 2, 0}}));
      return true;
    case MotionLaw::polynomial_345:
      append(whole({0.5, 15.0 / 16, 0, -10.0 / 16, 0, 3.0 / 16}));
      return true;
    case MotionLaw::polynomial_4567:
      append(whole({0.5, 35.0 / 32, 0, -35.0 / 32, 0, 21.0 / 32, 0, -5.0 / 32}));
      return true;
    case MotionLaw::modified_sine:
      append_universal({0.25, 0, 0.75}, place, pieces);
      return true;
    case MotionLaw::modified_trapezoid:
      append_universal({0.25, 0.5, 0.25}, place, pieces);
      return true;
    case MotionLaw::modified_constant_velocity:
      append_universal({0.125, 0, 0.375}, place, pieces);
      return true;
    case MotionLaw::double_harmonic:
      append(double_harmonic(segment.rise < 0));
      return true;
    case MotionLaw::universal:
      if (!is_valid(segment.shape)) return false;
      append_universal(segment.shape, place, pieces);
      return true;
    case MotionLaw::polynomial:
      return append_polynomial(segment, begin, start, index, pieces);
    case MotionLaw::spline:
      return append_spline(segment, begin, start, index, pieces);
  }
  return false;
}

std::optional<PeakFactors> handbook_factors(MotionLaw law) {
  switch (law) {
    case MotionLaw::dwell:
      return PeakFactors{0, 0, 0};
    case MotionLaw::constant_velocity:
      return PeakFactors{1, kInfinity, kInfinity};
    case MotionLaw::constant_acceleration:
      return PeakFactors{2, 4, kInfinity};
    case MotionLaw::harmonic:
      return PeakFactors{1.5708, 4.9348, 15.503};
    case MotionLaw::cycloidal:
      return PeakFactors{2, 6.2832, 39.478};
    case MotionLaw::polynomial_345:
      return PeakFactors{1.875, 5.7735, 60};
    case MotionLaw::polynomial_4567:
      return PeakFactors{2.1875, 7.5132, 52.5};
    case MotionLaw::modified_sine:
      return PeakFactors{1.7596, 5.5280, 69.47};
    case MotionLaw::modified_trapezoid:
      return PeakFactors{2, 4.8881, 61.43};
    case MotionLaw::modified_constant_velocity:
      return PeakFactors{1.28, 8.01, 201.4};
    case MotionLaw::double_harmonic:
      return PeakFactors{2.04, 9.87, 42.4};
    case MotionLaw::universal:
    case MotionLaw::polynomial:
    case MotionLaw::spline:
      return std::nullopt;
  }
  return std::nullopt;
}

template void append_universal(const UniversalShape<double>& shape, const double& begin,
                               const double& over, const double& start, const double& rise,
                               int index, std::vector<Piece>& pieces);

}  // namespace cognate::cam
