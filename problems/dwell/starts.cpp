#include "problems/dwell/starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/random.hpp"
#include "problems/chain/output/dyad.hpp"
#include "synthesis/chain/sweep.hpp"
#include "synthesis/chain/transform.hpp"

namespace cognate::problems {
namespace {

using synthesis::LineType;

constexpr int kChains = 160, kOutputs = 12;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

double log_between(std::mt19937_64& random, double low, double high) {
  return std::exp(uniform(random, std::log(low), std::log(high)));
}

std::size_t sample_at(int index) {
  return static_cast<std::size_t>(((index % kDrawnPositions) + kDrawnPositions) % kDrawnPositions);
}

int samples_of(double angle) {
  return std::max(3, static_cast<int>(std::lround(angle * kDrawnPositions / kTurn)) + 1);
}

/// Whether the point that carries the output moves along a circle about a pivot all the time: no
/// other circle can be near it.
bool circles(const DwellSpace& space) {
  const int carrier = space.lines[static_cast<std::size_t>(space.to)].line.first;
  const auto& line = space.lines[static_cast<std::size_t>(carrier)].line;
  const auto is_pivot = [&](int before) {
    return before >= 0 &&
           space.lines[static_cast<std::size_t>(before)].line.type == LineType::pivot;
  };
  return is_pivot(line.first) || is_pivot(line.second);
}

/// Whether a circle near a part of the carrier's path gives the output's dyad.
bool hangs_on_circle(const DwellSpace& space) {
  if (space.problem->dwells.size() != 1 || circles(space)) return false;
  return space.slides() ? ends_in_free_slider(space) : ends_in_free_dyad(space);
}

/// A part of the turn: where it begins, the middle of the output there, and how far it deviates.
struct Window {
  double start = 0, level = 0, half_band = kInfinite;
};

/// The output of a chain at the drawn positions: swing, and what it deviates in a window.
class DrawnOutput {
 public:
  DrawnOutput(const DwellSpace& space, const synthesis::ChainDesign& design) {
    const std::vector<double> side(design.side.begin(), design.side.end());
    FreeChain chain(space, design.parameters, side);
    WantedOutput reference;
    for (int i = 0; i < kDrawnPositions; ++i) {
      chain.at(kTurn * i / kDrawnPositions);
      if (i == 0) reference = space.output(chain);
      outputs_[sample_at(i)] = space.error(chain, reference);
    }
  }

  double swing() const {
    const auto [least, greatest] = std::ranges::minmax(outputs_);
    return greatest - least;
  }

  /// Of `count` samples from `first` on.
  Window window(int first, int count, double start) const {
    double least = kInfinite, greatest = -kInfinite;
    for (int i = 0; i < count; ++i) {
      least = std::min(least, outputs_[sample_at(first + i)]);
      greatest = std::max(greatest, outputs_[sample_at(first + i)]);
    }
    const bool known = std::isfinite(outputs_[0]);
    return {start, 0.5 * (least + greatest), known ? 0.5 * (greatest - least) : kInfinite};
  }

 private:
  std::array<double, kDrawnPositions> outputs_{};
};

class DwellDraw {
 public:
  DwellDraw(const DwellSpace& space, std::mt19937_64& random) : space_(space), random_(random) {}

  std::optional<DwellDesign> best() {
    hangs_on_circle(space_) ? draw_on_circles() : draw_whole();
    if (best_.start.empty()) return std::nullopt;
    return best_;
  }

 private:
  void draw_on_circles() {
    const OutputCarrier carrier(space_, space_.problem->constraints.transmission_angle);
    const int count = samples_of(space_.problem->dwells[0].over);
    for (int i = 0; i < kChains; ++i) {
      const auto drawn = draw(carrier.space(), random_);
      if (!drawn) continue;
      for (int first = 0; first < kDrawnPositions; first += 4) {
        const int begin = fixed_start().value_or(first);
        window_.clear();
        for (int k = 0; k < count; ++k) window_.push_back(drawn->curve[sample_at(begin + k)]);
        const CircleNear circle = circle_near(window_);
        if (space_.slides()) {
          if (circle.deviation < least_) hang_slider(carrier.space(), *drawn, circle, begin);
        } else if (circle.deviation < 6 * least_) {
          hang_output(*drawn, circle, begin);
        }
        if (fixed_start()) break;
      }
    }
  }

  std::optional<int> fixed_start() const {
    const auto& from = space_.problem->dwells[0].from;
    if (!from) return std::nullopt;
    return static_cast<int>(std::lround(*from * kDrawnPositions / kTurn));
  }

  void hang_output(const DrawnChain& carrier, const CircleNear& circle, int begin) {
    for (int i = 0; i < kOutputs; ++i) {
      const double length = log_between(random_, 0.4, 6);
      const double deviation = circle.deviation / length;
      if (deviation >= least_) continue;
      const Vec2d pivot = circle.centre + length * unit_vector(uniform(random_, 0, kTurn));
      const Vec2d point = carrier.curve[sample_at(begin)];
      const auto chain = hung(space_, carrier.design, pivot, circle, point);
      if (!chain) continue;
      const auto& from = space_.problem->dwells[0].from;
      take(*chain, {from.value_or(kTurn * begin / kDrawnPositions)}, deviation);
    }
  }

  /// The pin stands still in the circle's centre, whatever the direction of the guide. A carrier
  /// whose crank may begin anywhere is turned in place of a guide whose direction is given.
  void hang_slider(const ChainSpace& carrier, const DrawnChain& drawn, const CircleNear& circle,
                   int begin) {
    const bool turns = !fixed_start() && has_free_carrier(space_);
    const auto given = guide_direction(space_);
    for (int i = 0; i < kOutputs; ++i) {
      const double turned = turns ? uniform(random_, 0, kTurn) : 0;
      const Vec2d turn = unit_vector(turned);
      synthesis::ChainDesign chain = drawn.design;
      synthesis::transform(carrier.lines, turn, {}, chain.parameters);
      const Vec2d guide = unit_vector(given.value_or(uniform(random_, -kPi / 2, kPi / 2)));
      const CircleNear moved{turn * circle.centre, circle.radius, circle.deviation};
      const Vec2d point = turn * drawn.curve[sample_at(begin)];
      const auto whole = with_slider(space_, chain, guide, moved, point);
      if (!whole) continue;
      const auto& from = space_.problem->dwells[0].from;
      take(*whole, {from.value_or(kTurn * begin / kDrawnPositions + turned)}, circle.deviation);
    }
  }

  void draw_whole() {
    for (int i = 0; i < kChains; ++i) {
      const auto drawn = draw(space_, random_);
      if (!drawn) continue;
      const DrawnOutput output(space_, drawn->design);
      const auto [starts, worst] = stillest(output);
      take(drawn->design, starts, worst);
    }
  }

  struct Windows {
    std::vector<double> starts;
    double worst = kInfinite;  ///< half band
  };

  /// Where the output stands stillest, of two dwells at levels nearly as far apart as wanted.
  Windows stillest(const DrawnOutput& output) const {
    const auto& dwells = space_.problem->dwells;
    const auto first = windows(output, dwells.front()), second = windows(output, dwells.back());
    constexpr double kApartShare = 0.5;
    const double apart = kApartShare * space_.apart.value_or(0);
    Windows best;
    for (const Window& one : first) {
      if (dwells.size() == 1 && one.half_band < best.worst) best = {{one.start}, one.half_band};
      if (dwells.size() == 1) continue;
      for (const Window& two : second) {
        const double worst = std::max(one.half_band, two.half_band);
        if (worst >= best.worst || std::abs(one.level - two.level) < apart) continue;
        best = {{one.start, two.start}, worst};
      }
    }
    return best;
  }

  static std::vector<Window> windows(const DrawnOutput& output, const Dwell& dwell) {
    std::vector<Window> all;
    const int count = samples_of(dwell.over);
    if (dwell.from) {
      const auto first = static_cast<int>(std::lround(*dwell.from * kDrawnPositions / kTurn));
      return {output.window(first, count, *dwell.from)};
    }
    for (int first = 0; first < kDrawnPositions; ++first) {
      all.push_back(output.window(first, count, kTurn * first / kDrawnPositions));
    }
    return all;
  }

  /// Keeps a chain that is assembled over the turn within the limit and swings nearly as wanted.
  void take(const synthesis::ChainDesign& chain, std::vector<double> starts, double deviation) {
    if (deviation >= least_) return;
    double cosine = 0;
    const std::vector<double> side(chain.side.begin(), chain.side.end());
    const synthesis::ChainView<double> view{space_.lines.data(),
                                            static_cast<int>(space_.lines.size()),
                                            chain.parameters.data(), side.data()};
    synthesis::ChainPlace<double> place;
    for (int i = 0; i < kDrawnPositions; i += 2) {
      synthesis::place(view, unit_vector(kTurn * i / kDrawnPositions), place);
      for (const int joint : space_.joints) {
        cosine = std::max(cosine, std::abs(synthesis::transmission_cosine(view, place, joint)));
      }
    }
    constexpr double kAllowance = 0.1, kSwingShare = 0.8;
    if (!(cosine < std::min(space_.cosine_limit + kAllowance, 0.999))) return;
    if (DrawnOutput(space_, chain).swing() < kSwingShare * space_.swing_min) return;
    least_ = deviation;
    best_ = {chain, std::move(starts)};
  }

  const DwellSpace& space_;
  std::mt19937_64& random_;
  DwellDesign best_;
  std::vector<Vec2d> window_;
  double least_ = kInfinite;
};

}  // namespace

std::optional<DwellDesign> draw_dwell(const DwellSpace& space, std::mt19937_64& random) {
  return DwellDraw(space, random).best();
}

}  // namespace cognate::problems
