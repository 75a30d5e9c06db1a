#include "problems/dwell/starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/random.hpp"
#include "problems/chain/draw.hpp"
#include "synthesis/chain/sweep.hpp"

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

struct CircleNear {
  Vec2d centre;
  double radius = 0;
  double deviation = kInfinite;  ///< greatest distance from it
};

/// The circle nearest to `count` samples from `first` on, by the linear least squares of Kåsa.
CircleNear circle_near(const DrawnCurve& curve, int first, int count) {
  Vec2d mean;
  for (int i = 0; i < count; ++i) mean = mean + (1.0 / count) * curve[sample_at(first + i)];
  double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, zz = 0;
  for (int i = 0; i < count; ++i) {
    const Vec2d p = curve[sample_at(first + i)] - mean;
    const double square = squared_norm(p);
    xx += p.x * p.x;
    xy += p.x * p.y;
    yy += p.y * p.y;
    xz += p.x * square;
    yz += p.y * square;
    zz += square;
  }
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-12 * zz * zz)) return {};
  const Vec2d centre{(xz * yy - yz * xy) / (2 * determinant),
                     (yz * xx - xz * xy) / (2 * determinant)};
  CircleNear circle{mean + centre, std::sqrt(zz / count + squared_norm(centre)), 0};
  for (int i = 0; i < count; ++i) {
    circle.deviation =
        std::max(circle.deviation,
                 std::abs(norm(curve[sample_at(first + i)] - circle.centre) - circle.radius));
  }
  return circle;
}

int samples_of(double angle) {
  return std::max(3, static_cast<int>(std::lround(angle * kDrawnPositions / kTurn)) + 1);
}

/// Whether the point of a line moves along a circle about a pivot all the time: no other circle can
/// be near it.
bool circles(const DwellSpace& space, int index) {
  const auto& line = space.lines[static_cast<std::size_t>(index)].line;
  const auto is_pivot = [&](int before) {
    return before >= 0 &&
           space.lines[static_cast<std::size_t>(before)].line.type == LineType::pivot;
  };
  return is_pivot(line.first) || is_pivot(line.second);
}

/// Whether the output's dyad is the last line of its chain, after G, and free, so that a circle
/// fits it.
bool ends_in_free_dyad(const DwellSpace& space) {
  const auto& lines = space.lines;
  const auto to = static_cast<std::size_t>(space.to), from = static_cast<std::size_t>(space.from);
  const auto& dyad = lines[to].line;
  if (dyad.type != LineType::dyad || lines[from].line.type != LineType::pivot) return false;
  if (dyad.second != space.from || space.problem->dwells.size() != 1) return false;
  if (circles(space, dyad.first)) return false;
  const auto is_given = [&](std::size_t k, int count) {
    for (int i = 0; i < count; ++i) {
      const int place = lines[k].parameter + i;
      if (space.given[static_cast<std::size_t>(place)]) return true;
    }
    return false;
  };
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto& line = lines[k].line;
    const bool uses = line.first == space.from || line.second == space.from;
    if (k != to && uses) return false;
  }
  const bool is_last = to + 1 == lines.size() && from + 1 == to;
  return is_last && !is_given(to, 2) && !is_given(from, 2);
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
    const synthesis::ChainView<double> view{space.lines.data(),
                                            static_cast<int>(space.lines.size()),
                                            design.parameters.data(), side.data()};
    synthesis::ChainPlace<double> place;
    Vec2d reference{1, 0};
    for (int i = 0; i < kDrawnPositions; ++i) {
      synthesis::place(view, unit_vector(kTurn * i / kDrawnPositions), place);
      const Vec2d way = place.at[space.to] - place.at[space.from];
      if (i == 0) reference = way;
      angles_[sample_at(i)] = relative_angle(way, reference);
    }
  }

  double swing() const {
    const auto [least, greatest] = std::ranges::minmax(angles_);
    return greatest - least;
  }

  /// Of `count` samples from `first` on.
  Window window(int first, int count, double start) const {
    double least = kInfinite, greatest = -kInfinite;
    for (int i = 0; i < count; ++i) {
      least = std::min(least, angles_[sample_at(first + i)]);
      greatest = std::max(greatest, angles_[sample_at(first + i)]);
    }
    const bool known = std::isfinite(angles_[0]);
    return {start, 0.5 * (least + greatest), known ? 0.5 * (greatest - least) : kInfinite};
  }

 private:
  std::array<double, kDrawnPositions> angles_{};
};

class DwellDraw {
 public:
  DwellDraw(const DwellSpace& space, std::mt19937_64& random) : space_(space), random_(random) {}

  std::optional<DwellDesign> best() {
    ends_in_free_dyad(space_) ? draw_on_circles() : draw_whole();
    if (best_.start.empty()) return std::nullopt;
    return best_;
  }

 private:
  /// The chain up to E, the first point of the output's dyad.
  Topology carrying() const {
    Topology part = *space_.topology;
    const int point = space_.lines[static_cast<std::size_t>(space_.to)].line.first;
    part.lines.resize(static_cast<std::size_t>(space_.to));
    part.trace = point;
    return part;
  }

  void draw_on_circles() {
    const Topology part = carrying();
    ChainSpace carrier(part, TargetScale{}, space_.problem->constraints.transmission_angle);
    carrier.given.assign(space_.given.begin(),
                         space_.given.begin() + static_cast<std::ptrdiff_t>(carrier.given.size()));
    carrier.free.clear();
    for (const int parameter : space_.free) {
      if (static_cast<std::size_t>(parameter) < carrier.given.size()) {
        carrier.free.push_back(parameter);
      }
    }
    const int count = samples_of(space_.problem->dwells[0].over);
    for (int i = 0; i < kChains; ++i) {
      const auto drawn = draw(carrier, random_);
      if (!drawn) continue;
      for (int first = 0; first < kDrawnPositions; first += 4) {
        const int begin = fixed_start().value_or(first);
        const CircleNear circle = circle_near(drawn->curve, begin, count);
        if (circle.deviation < 6 * least_) hang_output(*drawn, circle, begin);
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
      synthesis::ChainDesign chain = carrier.design;
      const auto& output = space_.lines;
      const auto to = static_cast<std::size_t>(space_.to);
      chain.parameters.resize(space_.given.size());
      chain.side.resize(output.size(), 0);
      double* at = chain.parameters.data();
      at[output[static_cast<std::size_t>(space_.from)].parameter] = pivot.x;
      at[output[static_cast<std::size_t>(space_.from)].parameter + 1] = pivot.y;
      at[output[to].parameter] = circle.radius;
      at[output[to].parameter + 1] = length;
      const Vec2d point = carrier.curve[sample_at(begin)];
      chain.side[to] = cross(pivot - point, circle.centre - point) > 0 ? 1 : -1;
      const auto& assembly = space_.topology->lines[to].assembly;
      if (assembly && (*assembly == Assembly::open) != (chain.side[to] > 0)) continue;
      const auto& from = space_.problem->dwells[0].from;
      take(chain, {from.value_or(kTurn * begin / kDrawnPositions)}, deviation);
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
    const double apart = kApartShare * space_.problem->apart.value_or(0);
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
    if (DrawnOutput(space_, chain).swing() < kSwingShare * space_.problem->swing_min) return;
    least_ = deviation;
    best_ = {chain, std::move(starts)};
  }

  const DwellSpace& space_;
  std::mt19937_64& random_;
  DwellDesign best_;
  double least_ = kInfinite;
};

}  // namespace

std::optional<DwellDesign> draw_dwell(const DwellSpace& space, std::mt19937_64& random) {
  return DwellDraw(space, random).best();
}

}  // namespace cognate::problems
