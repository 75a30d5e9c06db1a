#include "analysis/layers/collisions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "analysis/layers/strip.hpp"
#include "analysis/mechanism/convert.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/convex_hull.hpp"
#include "analysis/numbers/hull_distance.hpp"

namespace cognate {
namespace {

constexpr int kFirstCells = 32;  // of a turn, or of the whole way of a slider
constexpr int kMostHalvings = 45;
constexpr std::size_t kMostCells = 200'000;  // of a pair
constexpr double kResolution = 1e-9;         // of the size
/// Within this part of the drive's scale of a change point either assembly is possible.
constexpr double kNearChange = 1e-6;
constexpr double kRoundUp = 1 + 1e-14;

double half_of(double low, double high) {
  return kRoundUp * (0.5 * (high - low)) + Strip::kRounding * std::abs(low);
}

/// The unit vector at the angles from middle − half to middle + half: cos and sin of half·t are 1 −
/// [0, half²/2] and half·t ± half³/6.
Vec2<Strip> direction_over(double middle, double half) {
  const double quarter = 0.25 * half * half;
  const Vec2<Strip> at_middle{rounded(std::cos(middle), 0, 0, 1),
                              rounded(std::sin(middle), 0, 0, 1)};
  const Vec2<Strip> turned{rounded(1 - quarter, 0, quarter, 1),
                           rounded(0, half, half * half * half / 6, half)};
  return at_middle * turned;
}

/// A plate in a cell: its corners, and where they are in the middle of it.
struct PlacedPlate {
  std::vector<Vec2<Strip>> corners;
  std::vector<Vec2d> middles;
  double doubt = 0;   ///< how far from those in the middle of the cell the corners may be there
  double spread = 0;  ///< and anywhere in it
};

/// How the enclosures of two plates are to each other in a cell.
struct Separation {
  bool free = false;
  bool collides = false;  ///< in the middle of the cell
  double undecided = 0;   ///< how far the enclosures extend along the line between the plates
};

Separation separation(const PlacedPlate& a, const PlacedPlate& b, double required) {
  Separation found;
  found.undecided = a.spread + b.spread;
  const Vec2d gap = hull_gap(a.middles, b.middles);
  const double distance = norm(gap);
  found.collides = kRoundUp * (distance + a.doubt + b.doubt) < required;
  if (!(distance > 0) || found.collides) return found;
  const Strip x = gap.x / distance, y = gap.y / distance;
  double least = std::numeric_limits<double>::infinity(), spread = 0;
  for (const Vec2<Strip>& from : a.corners) {
    for (const Vec2<Strip>& to : b.corners) {
      const Strip apart = x * (to.x - from.x) + y * (to.y - from.y);
      if (!std::isfinite(apart.radius)) return found;
      least = std::min(least, apart.low());
      spread = std::max(spread, apart.spread());
    }
  }
  found.free = least > kRoundUp * required;
  found.undecided = std::min(found.undecided, spread);
  return found;
}

class CollisionFinder {
 public:
  CollisionFinder(const Mechanism<double>& mechanism, const AssemblyRanges& motion,
                  std::span<const PlatePair> pairs, double clearance,
                  const std::function<bool()>& stop)
      : mechanism_(convert<Strip>(mechanism)),
        motion_(motion),
        given_(pairs),
        stop_(stop),
        bodies_(static_cast<std::size_t>(body_count(mechanism))),
        closures_(mechanism.dyads.size()),
        sides_(mechanism.dyads.size()),
        strip_sides_(mechanism.dyads.size()),
        states_(pairs.size()) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      states_[i].first = number_of(pairs[i].first);
      states_[i].second = number_of(pairs[i].second);
      states_[i].required = pairs[i].first->radius + pairs[i].second->radius + clearance;
    }
    placed_.resize(plates_.size());
    found_.pairs.resize(pairs.size());
  }

  Collisions find() {
    std::vector<std::size_t> all(given_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    const bool rising = motion_.start <= motion_.end;
    const std::size_t runs = motion_.runs.size();
    for (std::size_t i = 0; i < runs; ++i) {
      const AssemblyRange& run = motion_.runs[rising ? i : runs - 1 - i];
      const bool turns = !driven_by_length(mechanism_.drive);
      const double share = turns ? (run.to - run.from) / kTurn : 1;
      const int cells = std::max(1, static_cast<int>(std::ceil(kFirstCells * share)));
      for (int k = 0; k < cells; ++k) {
        const int cell = rising ? k : cells - 1 - k;
        const auto at = [&](int end) {
          return end == cells ? run.to : std::lerp(run.from, run.to, 1.0 * end / cells);
        };
        examine(run, at(cell), at(cell + 1), 0, all);
      }
    }
    return std::move(found_);
  }

 private:
  struct State {
    std::size_t first = 0, second = 0;  ///< of `plates_`
    double required = 0;                ///< distance of the cores
    std::size_t cells = 0;
    bool collides = false;  ///< proven for some position
  };

  std::size_t number_of(const Plate* plate) {
    const auto found = std::ranges::find(plates_, plate);
    if (found != plates_.end()) return static_cast<std::size_t>(found - plates_.begin());
    plates_.push_back(plate);
    for (const Vec2d& corner : plate->corners) size_ = std::max(size_, norm(corner));
    for (const auto& other : plate->others) size_ = std::max(size_, norm(other.at));
    size_ = std::max(size_, plate->radius);
    return plates_.size() - 1;
  }

  bool is_open(std::size_t pair) const { return found_.pairs[pair].passage == Passage::free; }

  /// The cell from `low` to `high` of `run` for those of `pairs` that are still open.
  void examine(const AssemblyRange& run, double low, double high, int halvings,
               const std::vector<std::size_t>& pairs) {
    if (std::ranges::none_of(pairs, [&](std::size_t pair) { return is_open(pair); })) return;
    if (!found_.complete || (stop_ && stop_())) {
      found_.complete = false;
      return;
    }
    const double middle = 0.5 * (low + high);
    const bool rising = motion_.start <= motion_.end;
    place(run, low, high);
    std::vector<std::size_t> left;
    for (const std::size_t pair : pairs) {
      if (is_open(pair) && !is_settled(pair, rising ? low : high, halvings)) left.push_back(pair);
    }
    if (left.empty()) return;
    examine(run, rising ? low : middle, rising ? middle : high, halvings + 1, left);
    examine(run, rising ? middle : low, rising ? high : middle, halvings + 1, left);
  }

  /// Whether the pair needs no halves of the cell in which the bodies are placed, which begins at
  /// `begin`.
  bool is_settled(std::size_t pair, double begin, int halvings) {
    State& state = states_[pair];
    const Separation now = separation(placed_[state.first], placed_[state.second], state.required);
    if (now.free) return true;
    state.collides = state.collides || now.collides;
    ++state.cells;
    const bool decide = now.undecided <= kResolution * size_ || halvings >= kMostHalvings ||
                        state.cells >= kMostCells;
    if (!decide) return false;
    found_.pairs[pair] = {state.collides ? Passage::collides : Passage::unresolved, begin};
    return true;
  }

  /// All bodies and plates over a cell.
  void place(const AssemblyRange& run, double low, double high) {
    ++found_.cells;
    const double middle = 0.5 * (low + high), half = half_of(low, high);
    sides_at(run, middle, sides_);
    std::ranges::copy(sides_, strip_sides_.begin());
    const double near = kNearChange * motion_.scale;
    for (const Change& change : run.changes) {
      if (change.drive < low - near || change.drive > high + near) continue;
      strip_sides_[static_cast<std::size_t>(change.dyad)] = {0, 0, 1};
    }
    DrivePosition<Strip> drive;
    if (driven_by_length(mechanism_.drive)) {
      drive.displacement = {middle, half, 0};
    } else {
      drive.direction = direction_over(middle, half);
    }
    evaluate<0, Strip>(mechanism_, drive, strip_sides_, bodies_, closures_);
    for (std::size_t i = 0; i < plates_.size(); ++i) place(*plates_[i], placed_[i]);
  }

  void place(const Plate& plate, PlacedPlate& placed) const {
    const auto& body = bodies_[static_cast<std::size_t>(plate.body)];
    placed.corners.clear();
    placed.middles.clear();
    placed.doubt = placed.spread = 0;
    for (const Vec2d& corner : plate.corners) add_corner(body, corner, placed);
    if (plate.others.empty()) return;
    for (const auto& [other, corner] : plate.others) {
      add_corner(bodies_[static_cast<std::size_t>(other)], corner, placed);
    }
    if (std::isfinite(placed.doubt)) placed.middles = convex_hull(std::move(placed.middles), 0);
  }

  static void add_corner(const BodyMotion<Strip, 0>& body, const Vec2d& corner,
                         PlacedPlate& placed) {
    const Vec2<Strip> at = motion_terms::place(body, Vec2<Strip>{corner.x, corner.y});
    const double doubt = at.x.radius + at.y.radius, spread = at.x.spread() + at.y.spread();
    if (!std::isfinite(doubt)) placed.doubt = placed.spread = kInfinity;
    placed.doubt = std::max(placed.doubt, doubt);
    placed.spread = std::max(placed.spread, spread);
    placed.corners.push_back(at);
    placed.middles.push_back({at.x.middle, at.y.middle});
  }

  Mechanism<Strip> mechanism_;
  const AssemblyRanges& motion_;
  std::span<const PlatePair> given_;
  const std::function<bool()>& stop_;
  std::vector<BodyMotion<Strip, 0>> bodies_;
  std::vector<DyadClosure<Strip>> closures_;
  std::vector<double> sides_;
  std::vector<Strip> strip_sides_;
  std::vector<const Plate*> plates_;
  std::vector<PlacedPlate> placed_;
  std::vector<State> states_;
  double size_ = 0;
  Collisions found_;
};

}  // namespace

Collisions find_collisions(const Mechanism<double>& mechanism, const AssemblyRanges& motion,
                           std::span<const PlatePair> pairs, double clearance,
                           const std::function<bool()>& stop) {
  return CollisionFinder(mechanism, motion, pairs, clearance, stop).find();
}

}  // namespace cognate
