#include "analysis/cam/turn_extremes.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::cam {
namespace {

bool belongs(const StrokePart& part, MotionPart stretch) {
  switch (stretch) {
    case MotionPart::rises:
      return part.stroke == Stroke::rise;
    case MotionPart::falls:
      return part.stroke == Stroke::fall;
    case MotionPart::dwells:
      return part.stroke == Stroke::dwell;
    default:
      return true;
  }
}

/// The size of f over the turn, from a few places of each piece: what rounding is relative to.
double size_of(const MotionProgramme& programme, MotionPart stretch, MotionFunction f) {
  double size = 0;
  for (const StrokePart& part : programme.stroke_parts()) {
    if (!belongs(part, stretch)) continue;
    const auto& piece = programme.pieces()[static_cast<std::size_t>(part.piece)];
    for (const double share : {0.0, 0.3, 0.5, 0.7, 1.0}) {
      const double value = std::abs(f(motion_at(piece, std::lerp(part.from, part.to, share))));
      if (std::isfinite(value)) size = std::max(size, value);
    }
  }
  return size;
}

TurnPlace place_of(const MotionPiece<double>& piece, int index, double t) {
  return {piece.begin + t * piece.span, index, t};
}

/// Calls `use(part, piece)` for the parts of a stretch.
template <class Use>
void each_part(const MotionProgramme& programme, MotionPart stretch, Use use) {
  for (const StrokePart& part : programme.stroke_parts()) {
    if (belongs(part, stretch)) use(part, programme.pieces()[static_cast<std::size_t>(part.piece)]);
  }
}

}  // namespace

std::optional<TurnExtremes> turn_extremes(const MotionProgramme& programme, MotionPart stretch,
                                          MotionFunction f) {
  const double size = size_of(programme, stretch, f);
  std::optional<TurnExtremes> found;
  each_part(programme, stretch, [&](const StrokePart& part, const MotionPiece<double>& piece) {
    const auto of_share = [&](double t) { return f(motion_at(piece, t)); };
    const Extremes here = extremes(of_share, part.from, part.to, size);
    const ExtremeAt least{place_of(piece, part.piece, here.least.at), here.least.value};
    const ExtremeAt greatest{place_of(piece, part.piece, here.greatest.at), here.greatest.value};
    if (!found) found = TurnExtremes{least, greatest};
    // Written so that a value that is no number gives way to any.
    if (!(found->least.value <= least.value)) found->least = least;
    if (!(found->greatest.value >= greatest.value)) found->greatest = greatest;
  });
  return found;
}

std::vector<ExtremeAt> local_maxima(const MotionProgramme& programme, MotionPart stretch,
                                    MotionFunction f, double floor) {
  const double size = size_of(programme, stretch, f);
  std::vector<ExtremeAt> maxima;
  std::vector<Extreme> all;
  each_part(programme, stretch, [&](const StrokePart& part, const MotionPiece<double>& piece) {
    all.clear();
    local_extremes([&](double t) { return f(motion_at(piece, t)); }, part.from, part.to, size, all);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool above_before = i == 0 || all[i].value >= all[i - 1].value;
      const bool above_after = i + 1 == all.size() || all[i].value >= all[i + 1].value;
      if (above_before && above_after && all[i].value >= floor) {
        maxima.push_back({place_of(piece, part.piece, all[i].at), all[i].value});
      }
    }
  });
  return maxima;
}

std::optional<TurnExtremes> turn_extremes(const MotionProgramme& programme, MotionPart stretch,
                                          const CamSystem<double>& cam, CamQuantity quantity) {
  return turn_extremes(programme, stretch,
                       [&](const FollowerMotion<double>& m) { return value_of(quantity, cam, m); });
}

FollowerMotion<double> motion_at(const MotionProgramme& programme, const TurnPlace& place) {
  return motion_at(programme.pieces()[static_cast<std::size_t>(place.piece)], place.t);
}

}  // namespace cognate::cam
