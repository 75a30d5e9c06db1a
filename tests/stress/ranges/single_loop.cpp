#include "tests/stress/ranges/single_loop.hpp"

#include <boost/math/constants/constants.hpp>

#include "analysis/numbers/constants.hpp"
#include "tests/stress/ranges/loop_shape.hpp"

namespace cognate::stress {
namespace {

/// Places in a quarter turn: evenly, and crowded about its middle, where all links can lie in line.
template <class Real>
const std::vector<Real>& tangents() {
  static const std::vector<Real> all = [] {
    std::vector<Real> list{Real(0)};
    const Real border = Real(1) / (1 + boost::math::constants::root_two<Real>());
    constexpr int kEven = 24;
    for (int i = 1; i <= kEven; ++i) list.push_back(border * i / kEven);
    for (Real near = border / kEven / 2; near > 1e-13; near /= 4) list.push_back(near);
    for (std::size_t i = list.size() - 1; i > 0; --i) list.push_back(-list[i]);
    std::sort(list.begin(), list.end());
    list.pop_back();  // the next quarter's first
    return list;
  }();
  return all;
}

template <class Real>
struct Part {
  std::vector<Place<Real>> places;
  bool starts_dead = false, ends_dead = false;
};

/// Follows one mechanism.
template <class Real>
class Follower {
 public:
  explicit Follower(const SingleLoop& loop) : loop_(loop), shape_(loop) {}

  LoopTruth truth() {
    LoopTruth truth;
    const double sense = loop_.end < loop_.start ? -1 : 1;
    const Place<Real> from = place(loop_.start), to = place(loop_.end);
    const auto parts = closed_parts(path(from, to, sense));
    truth.ranges = static_cast<int>(parts.size());
    truth.closes = !parts.empty();
    truth.crank_turns = turns();
    if (!truth.closes) return truth;
    for (const auto& part : parts) add_points(part, truth);
    Track track;
    trace(range_driven(parts, sense), loop_.side, track);
    truth.stroke = track.stroke(loop_.slides());
    truth.keeps_direction = track.keeps_direction;
    Track all;
    for (const auto& part : parts) {
      all.last.reset();
      trace(part, loop_.side, all);
    }
    truth.least_transmission = all.least_transmission;
    truth.greatest_transmission = all.greatest_transmission;
    for (const bool dead : {parts.front().starts_dead, parts.front().ends_dead}) {
      if (dead && loop_.type == LoopType::tangent_generator) truth.reaches_infinity = true;
    }
    if (loop_.type != LoopType::tangent_generator) truth.circuit = circuit(parts.front(), sense);
    return truth;
  }

 private:
  /// What an output does along a walk.
  struct Track {
    std::optional<Position<Real>> last{}, before{};
    double value = 0, least = 0, greatest = 0;
    double least_transmission = 180, greatest_transmission = 0;
    bool keeps_direction = true;

    void offer(double at) {
      least = std::min(least, at);
      greatest = std::max(greatest, at);
    }
    double stroke(bool slides) const {
      return (slides ? 1 : kDegreesInRadian) * (greatest - least);
    }
  };

  double frame_degrees() const {
    const bool has_slide =
        loop_.type == LoopType::slider_crank || loop_.type == LoopType::fixed_block ||
        loop_.type == LoopType::scotch_yoke || loop_.type == LoopType::tangent_generator ||
        loop_.type == LoopType::elliptic_trammel;
    return has_slide ? loop_.direction
                     : std::atan2(loop_.frame_y, loop_.frame_x) * kDegreesInRadian;
  }

  Place<Real> place(double degrees) const {
    using std::tan;
    const double turned = degrees - frame_degrees();
    const double quarter = std::round(turned / 90);
    const Real half = (Real(degrees) - Real(frame_degrees()) - Real(90 * quarter)) *
                      boost::math::constants::pi<Real>() / 360;
    return {static_cast<int>(quarter), half == 0 ? Real(0) : Real(tan(half))};
  }

  static bool is_before(const Place<Real>& a, const Place<Real>& b) {
    return a.quarter != b.quarter ? a.quarter < b.quarter : a.t < b.t;
  }

  /// Places between an end and what is next to it, crowded towards the end, in the order from
  /// there.
  static std::vector<Place<Real>> crowded(const Place<Real>& end, const Place<Real>& inside) {
    constexpr double kNearest = 1e-13;  // nearer to where links lie in line, rounding decides
    std::vector<Place<Real>> places;
    Real step = (inside.from_quarter(end.quarter).t - end.t) / 2;
    for (; std::abs(static_cast<double>(step)) > kNearest; step /= 4) {
      places.push_back({end.quarter, end.t + step});
    }
    std::reverse(places.begin(), places.end());
    return places;
  }

  /// From `from` to `to` with all places between, crowded towards both.
  static std::vector<Place<Real>> path(const Place<Real>& from, const Place<Real>& to,
                                       double sense) {
    const Place<Real>& low = sense > 0 ? from : to;
    const Place<Real>& high = sense > 0 ? to : from;
    std::vector<Place<Real>> all{low};
    for (int quarter = low.quarter; quarter <= high.quarter; ++quarter) {
      for (const Real& t : tangents<Real>()) {
        const Place<Real> here{quarter, t};
        if (is_before(low, here) && is_before(here, high)) all.push_back(here);
      }
    }
    all.push_back(high);
    const auto last = crowded(high, all[all.size() - 2]);
    all.insert(all.end() - 1, last.rbegin(), last.rend());
    const auto first = crowded(low, all[1]);
    all.insert(all.begin() + 1, first.begin(), first.end());
    if (sense < 0) std::reverse(all.begin(), all.end());
    return all;
  }

  bool closes(const Place<Real>& at) const {
    const Real gap = shape_.gap(at);
    return loop_.type == LoopType::tangent_generator ? gap > 0 : gap >= -tiny();
  }
  bool touches(const Place<Real>& at) const {
    const Real gap = shape_.gap(at);
    return at.t == 0 && loop_.tie != Tie::none && gap <= tiny() && gap >= -tiny();
  }
  /// Of a gap that is zero but for the rounding of 113 bits.
  Real tiny() const { return loop_.tie == Tie::none ? Real(0) : Real(1e-29); }

  /// Between a place that closes and a neighbour that does not.
  Place<Real> limit(Place<Real> closed, Place<Real> open) const {
    open = open.from_quarter(closed.quarter);
    for (int i = 0; i < std::numeric_limits<Real>::digits + 8; ++i) {
      const Place<Real> middle{closed.quarter, (closed.t + open.t) / 2};
      (closes(middle) ? closed : open) = middle;
    }
    return closed;
  }

  /// The parts of `all` that close, with their ends.
  std::vector<Part<Real>> closed_parts(const std::vector<Place<Real>>& all) const {
    std::vector<Part<Real>> parts;
    bool is_open = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool here = closes(all[i]);
      if (here && !is_open) {
        parts.emplace_back();
        if (i > 0) add_end(parts.back(), limit(all[i], all[i - 1]), all[i], true);
        is_open = true;
      }
      if (here) parts.back().places.push_back(all[i]);
      if (!here && is_open) {
        add_end(parts.back(), limit(all[i - 1], all[i]), all[i - 1], false);
        is_open = false;
      }
    }
    return parts;
  }

  /// A dead end, with places crowded towards it.
  static void add_end(Part<Real>& part, const Place<Real>& end, const Place<Real>& inside,
                      bool first) {
    std::vector<Place<Real>> places = crowded(end, inside);
    places.insert(places.begin(), end);
    if (!first) std::reverse(places.begin(), places.end());
    part.places.insert(part.places.end(), places.begin(), places.end());
    (first ? part.starts_dead : part.ends_dead) = true;
  }

  /// The first part. Where a drive begins within a range, and what passes the start a turn later
  /// goes on there smoothly as it began, that is before it.
  Part<Real> range_driven(const std::vector<Part<Real>>& parts, double sense) {
    const Part<Real>& first = parts.front();
    const bool is_whole = parts.size() == 1 && !first.ends_dead;
    const bool comes_back = std::abs(loop_.end - loop_.start) >= 360 * (1 - 1e-12);
    if (is_whole || first.starts_dead || !comes_back) return first;
    const int turn = sense > 0 ? 4 : -4;
    const Place<Real> again{first.places.front().quarter + turn, first.places.front().t};
    const auto is_before_again = [&](const Place<Real>& at) {
      constexpr double kRounding = 1e-12;  // of an end 360° after the start
      if (at.quarter == again.quarter && std::abs(static_cast<double>(at.t - again.t)) < kRounding)
        return false;
      return sense > 0 ? is_before(at, again) : is_before(again, at);
    };
    for (std::size_t i = 1; i < parts.size(); ++i) {
      const auto& places = parts[i].places;
      if (!is_before_again(places.front()) || is_before_again(places.back())) continue;
      Part<Real> joined{{}, parts[i].starts_dead, first.ends_dead};
      std::copy_if(places.begin(), places.end(), std::back_inserter(joined.places),
                   is_before_again);
      Part<Real> until_start = joined;
      for (const Place<Real>& at : first.places) {
        joined.places.push_back({at.quarter + turn, at.t});
      }
      constexpr std::size_t kBeyond = 4;
      const auto beyond = std::min(until_start.places.size() + kBeyond, joined.places.size());
      until_start.places.assign(joined.places.begin(), joined.places.begin() + beyond);
      Track ignored;
      return trace(until_start, loop_.side, ignored) == loop_.side ? joined : first;
    }
    return first;
  }

  double drive(const Place<Real>& at) const { return at.degrees() + frame_degrees(); }

  void add_points(const Part<Real>& part, LoopTruth& truth) const {
    if (part.starts_dead) truth.dead_points.push_back(drive(part.places.front()));
    if (part.ends_dead) truth.dead_points.push_back(drive(part.places.back()));
    for (const auto& at : part.places) {
      if (touches(at)) truth.change_points.push_back(drive(at));
    }
  }

  bool turns() const {
    for (int quarter = 0; quarter < 4; ++quarter) {
      if (!closes({quarter, Real(0)})) return false;
    }
    return loop_.type != LoopType::tangent_generator;
  }

  /// From `a` to `b` of the output.
  double step(const Position<Real>& a, const Position<Real>& b) const {
    if (loop_.slides()) return static_cast<double>(b.output.x - a.output.x);
    return turn(a.output, b.output);
  }
  static double turn(const Plane<Real>& a, const Plane<Real>& b) {
    return std::atan2(static_cast<double>(a.x * b.y - a.y * b.x),
                      static_cast<double>(a.x * b.x + a.y * b.y));
  }

  /// How far `next` lies from where the last two positions point to, `ahead` times as far again.
  double bend(const Track& track, const Position<Real>& next, const Real& ahead) const {
    const auto &a = track.before->output, &b = track.last->output;
    const Real x = b.x + ahead * (b.x - a.x) - next.output.x;
    const Real y = b.y + ahead * (b.y - a.y) - next.output.y;
    return static_cast<double>(x * x + y * y);
  }

  /// Walks along `part` from assembly `side`; returns the assembly at its end.
  int trace(const Part<Real>& part, int side, Track& track) {
    for (std::size_t i = 0; i < part.places.size(); ++i) {
      const auto& here = part.places[i];
      const bool was_touch = i > 1 && touches(part.places[i - 1]);
      if (touches(here) && i > 0 && i + 1 < part.places.size()) {  // both sides are the same
        if (const auto position = shape_.at(here, side)) add_transmission(track, *position);
        continue;
      }
      if (was_touch) {
        const auto same = shape_.at(here, side), other = shape_.at(here, -side);
        const Real last = part.places[i - 2].t;
        const Real ahead = i > 2 ? Real((here.t - last) / (last - part.places[i - 3].t)) : Real(1);
        const bool turns_back =
            track.before && bend(track, *other, ahead) < bend(track, *same, ahead);
        if (turns_back) side = -side;
      }
      const auto position = shape_.at(here, side);
      if (!position) continue;
      advance(track, *position);
      add_transmission(track, *position);
      if (i > 0 && i + 1 < part.places.size()) refine(part, i, side, track);
    }
    return side;
  }

  static void add_transmission(Track& track, const Position<Real>& position) {
    track.least_transmission = std::min(track.least_transmission, position.transmission);
    track.greatest_transmission = std::max(track.greatest_transmission, position.transmission);
  }

  void advance(Track& track, const Position<Real>& position) const {
    if (track.last) {
      track.value += step(*track.last, position);
      track.offer(track.value);
      const double turned = turn(track.last->coupler, position.coupler);
      if (std::abs(turned) > 1e-9) track.keeps_direction = false;
    }
    track.before = track.last;
    track.last = position;
  }

  /// An extreme of the output about place `i` of `part`, at which `track` stands.
  void refine(const Part<Real>& part, std::size_t i, int side, Track& track) const {
    const Place<Real>& here = part.places[i];
    const Place<Real> before = part.places[i - 1].from_quarter(here.quarter);
    const Place<Real> after = part.places[i + 1].from_quarter(here.quarter);
    if (touches(before) || touches(after)) return;
    const Position<Real> reference = *track.last;
    const auto value = [&](const Real& t) {
      return step(reference, *shape_.at({here.quarter, t}, side));
    };
    const double last = value(before.t), next = value(after.t);
    if (last * next <= 0) return;
    const double sense = last < 0 ? 1 : -1;
    Real a = before.t, b = after.t;
    const Real share = 0.6180339887498949;
    double best = 0;
    for (int k = 0; k < 40; ++k) {
      const Real x = b - share * (b - a), y = a + share * (b - a);
      const double at_x = sense * value(x), at_y = sense * value(y);
      best = std::max({best, at_x, at_y});
      (at_x < at_y ? a : b) = at_x < at_y ? x : y;
    }
    track.offer(track.value + sense * best);
  }

  /// Through all branches, from within the first part on.
  double circuit(const Part<Real>& first, double sense) {
    Part<Real> entry = first;
    std::size_t middle = first.places.size() / 2;
    while (touches(first.places[middle])) ++middle;
    entry.places.resize(middle + 1);
    Track track;
    const int side = trace(entry, loop_.side, track);
    const Place<Real> begin = first.places[middle];
    const auto beyond = [&](int quarters) {
      return Place<Real>{begin.quarter + quarters, begin.t};
    };
    track = {};
    if (turns()) {
      const int quarters = (loop_.tie != Tie::none ? 8 : 4) * static_cast<int>(sense);
      trace(closed_parts(path(begin, beyond(quarters), sense)).front(), side, track);
      return finish(track, false);
    }
    // Back to the start of the range, over all of it, and back on the other assemblies.
    Part<Real> whole = closed_parts(path(begin, beyond(-4), -1)).front();
    Track back;
    const int side_at_start = trace(whole, side, back);
    const Part<Real> onward = closed_parts(path(begin, beyond(4), 1)).front();
    std::reverse(whole.places.begin(), whole.places.end());
    whole.places.insert(whole.places.end(), onward.places.begin() + 1, onward.places.end());
    const int side_at_end = trace(whole, side_at_start, track);
    std::reverse(whole.places.begin(), whole.places.end());
    trace(whole, -side_at_end, track);
    return finish(track, std::abs(track.value) > 1 && !loop_.slides());
  }

  double finish(const Track& track, bool came_round) const {
    const double all = track.stroke(loop_.slides());
    return !loop_.slides() && (came_round || all > 360 - 1e-6) ? 360 : all;
  }

  const SingleLoop& loop_;
  LoopShape<Real> shape_;
};

}  // namespace

bool SingleLoop::slides() const {
  return type != LoopType::four_bar && type != LoopType::guide_bar &&
         type != LoopType::oscillating_block && type != LoopType::oldham_coupling;
}

LoopTruth truth_of(const SingleLoop& loop, bool needs_113_bits) {
  if (needs_113_bits) {
    return Follower<boost::multiprecision::cpp_bin_float_quad>(loop).truth();
  }
  return Follower<long double>(loop).truth();
}

}  // namespace cognate::stress
