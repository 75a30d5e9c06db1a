#include "analysis/linkage/defects.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/numbers/constants.hpp"

namespace cognate {
namespace {

constexpr double kSameAngle = 1e-7;

/// Which circuit a position lies on, and how far its crank is from the start of its range.
struct Place {
  int circuit = 0;
  double turn = 0;
};

/// The circuits of one linkage, distinguished by link lengths.
class Circuits {
 public:
  explicit Circuits(const FourBar& linkage)
      : ranges_(crank_ranges(lengths(linkage))),
        frame_angle_(frame_angle(linkage)),
        rotates_(crank_rotates(lengths(linkage))),
        sides_are_apart_(rotates_ && !is_change_point(lengths(linkage))) {}

  bool rotates() const { return rotates_; }

  /// In which the crank moves on that circuit.
  const CrankRange& range(int circuit) const {
    return ranges_[rotates_ ? 0 : std::size_t(circuit)];
  }

  /// Empty where the linkage does not close.
  std::optional<Place> find(const CrankPosition& at) const {
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      const auto turn = turn_within(ranges_[i], at.crank_angle - frame_angle_);
      if (!turn) continue;
      const bool is_other_side = sides_are_apart_ && at.side == Assembly::crossed;
      return Place{is_other_side ? 1 : int(i), *turn};
    }
    return std::nullopt;
  }

 private:
  static std::optional<double> turn_within(const CrankRange& range, double angle) {
    if (!std::isfinite(angle)) return std::nullopt;
    const double whole = std::floor((angle - range.from) / (kTurn));
    const double turn = angle - range.from - kTurn * whole;
    const double span = range.to - range.from;
    if (turn <= span + kSameAngle) return std::min(turn, span);
    if (turn >= kTurn - kSameAngle) return 0.0;
    return std::nullopt;
  }

  std::vector<CrankRange> ranges_;
  double frame_angle_;
  bool rotates_;
  bool sides_are_apart_;
};

/// Whether `places` follow one another round a cycle of length `period` in the sense of `sense`,
/// once at most.
bool follows_once_round(std::span<const double> places, double period, double sense) {
  const double same = kSameAngle * period / (kTurn);
  double travelled = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double step = sense * (places[i] - places[i - 1]) / period;
    const double forward = period * (step - std::floor(step));
    if (forward < period - same) travelled += forward;
  }
  return travelled <= period + same * double(places.size());
}

bool is_cyclic(std::span<const double> places, double period) {
  return follows_once_round(places, period, +1) || follows_once_round(places, period, -1);
}

bool is_monotone(std::span<const double> places) {
  bool rises = true, falls = true;
  for (std::size_t i = 1; i < places.size(); ++i) {
    rises = rises && places[i] >= places[i - 1] - kSameAngle;
    falls = falls && places[i] <= places[i - 1] + kSameAngle;
  }
  return rises || falls;
}

/// Whether the crank gets from each position to the next by the shorter way without leaving the
/// range in which the linkage closes.
bool goes_the_shorter_way(std::span<const CrankPosition> positions, std::span<const double> turns) {
  for (std::size_t i = 1; i < positions.size(); ++i) {
    const double shorter =
        std::remainder(positions[i].crank_angle - positions[i - 1].crank_angle, kTurn);
    const double within = turns[i] - turns[i - 1];
    const bool is_half_turn = std::abs(shorter) > kPi - kSameAngle;
    // The two are equal or differ by a whole turn.
    if (!is_half_turn && std::abs(within - shorter) > kPi) return false;
  }
  return true;
}

/// Places round a circuit of two branches of length `span`: out on the open one, back on the other.
std::vector<double> round_the_circuit(std::span<const CrankPosition> positions,
                                      std::span<const double> turns, double span) {
  std::vector<double> places;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const bool out = positions[i].side == Assembly::open;
    places.push_back(out ? turns[i] : 2 * span - turns[i]);
  }
  return places;
}

bool keeps_order(const Circuits& circuits, int circuit, std::span<const CrankPosition> positions,
                 std::span<const double> turns, bool changes_branch, Sequence sequence) {
  if (sequence == Sequence::any) return true;
  if (sequence == Sequence::timed) {
    return circuits.rotates() || goes_the_shorter_way(positions, turns);
  }
  const auto [from, to] = circuits.range(circuit);
  const double span = to - from;
  if (circuits.rotates()) return is_cyclic(turns, span);
  if (!changes_branch) return is_monotone(turns);
  return is_cyclic(round_the_circuit(positions, turns, span), 2 * span);
}

}  // namespace

std::optional<CrankRange> range_between(const FourBar& linkage,
                                        std::span<const double> crank_angles) {
  const Circuits circuits(linkage);
  std::optional<Place> least, greatest;
  for (const double angle : crank_angles) {
    const auto place = circuits.find({angle, linkage.assembly});
    if (!place || (least && place->circuit != least->circuit)) return std::nullopt;
    if (!least || place->turn < least->turn) least = place;
    if (!greatest || place->turn > greatest->turn) greatest = place;
  }
  if (!least) return std::nullopt;
  const double from = circuits.range(least->circuit).from;
  return CrankRange{from + least->turn, from + greatest->turn};
}

CrankPosition position_of(const FourBar& linkage, const Vec2d& b, const Vec2d& c) {
  const Vec2d crank = b - linkage.pivot_a;
  const bool is_left = cross(linkage.pivot_d - b, c - b) > 0;
  return {std::atan2(crank.y, crank.x), is_left ? Assembly::open : Assembly::crossed};
}

Defects find_defects(const FourBar& linkage, std::span<const CrankPosition> positions,
                     Sequence sequence) {
  const Circuits circuits(linkage);
  Defects defects;
  std::vector<double> turns;
  std::optional<int> circuit;
  for (const CrankPosition& position : positions) {
    const auto place = circuits.find(position);
    if (!place || (circuit && place->circuit != *circuit)) {
      defects.circuit = true;
    } else {
      circuit = place->circuit;
      turns.push_back(place->turn);
    }
    defects.branch = defects.branch || position.side != positions[0].side;
  }
  if (!defects.circuit && circuit) {
    defects.order = !keeps_order(circuits, *circuit, positions, turns, defects.branch, sequence);
  }
  return defects;
}

Defects find_defects(const FourBar& linkage, std::span<const double> crank_angles,
                     Sequence sequence) {
  std::vector<CrankPosition> positions;
  for (const double angle : crank_angles) positions.push_back({angle, linkage.assembly});
  return find_defects(linkage, std::span<const CrankPosition>(positions), sequence);
}

}  // namespace cognate
