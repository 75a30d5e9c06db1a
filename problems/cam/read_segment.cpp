#include "problems/cam/read_segment.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "problems/cam/read_conditions.hpp"
#include "problems/cam/rules.hpp"

namespace cognate::problems::reading {
namespace {

using cam::MotionLaw;

constexpr std::string_view kOver = "over_deg";

// Other names under which laws are known.
constexpr Named<MotionLaw> kSynonyms[] = {{"polynomial-345", MotionLaw::polynomial_345},
                                          {"345", MotionLaw::polynomial_345},
                                          {"poly345", MotionLaw::polynomial_345},
                                          {"polynomial-4567", MotionLaw::polynomial_4567},
                                          {"4567", MotionLaw::polynomial_4567},
                                          {"poly4567", MotionLaw::polynomial_4567},
                                          {"parabolic", MotionLaw::constant_acceleration},
                                          {"simple-harmonic", MotionLaw::harmonic},
                                          {"cycloid", MotionLaw::cycloidal}};

std::optional<MotionLaw> read_law(TableReader& table) {
  constexpr std::string_view kLaw = "law";
  if (!table.has(kLaw)) {
    table.fault(kLaw,
                "is missing; expected \"dwell\", \"harmonic\", \"cycloidal\", \"3-4-5\" or another "
                "that 'cognate list' names");
    return std::nullopt;
  }
  if (table.has_text(kLaw)) {
    const auto found = std::ranges::find(kSynonyms, *table.text(kLaw), &Named<MotionLaw>::name);
    if (found != std::end(kSynonyms)) return found->value;
  }
  return table.choice<MotionLaw>(kLaw);
}

bool has_fixed_places(MotionLaw law) {
  return law == MotionLaw::polynomial || law == MotionLaw::spline;
}

std::optional<Range> read_over(TableReader& table, std::optional<MotionLaw> law) {
  if (!table.has(kOver)) {
    table.fault(kOver, fmt::format("is missing; expected {}, or [min, max]", kCamAngle.allowed));
    return std::nullopt;
  }
  if (!table.has_array(kOver)) {
    const auto angle = table.number(kOver, kCamAngle);
    return angle ? std::optional(Range{*angle, *angle}) : std::nullopt;
  }
  const auto range = table.range(kOver, kCamAngle);
  if (range && law && has_fixed_places(*law) && range->min < range->max) {
    table.fault(kOver, fmt::format("is a range, but what a {} goes through stands at fixed angles; "
                                   "expected {}",
                                   to_string(*law), kCamAngle.allowed));
    return std::nullopt;
  }
  return range;
}

std::optional<double> read_rise(TableReader& table, MotionLaw law, bool oscillating) {
  const std::string_view key = oscillating ? "rise_deg" : "rise";
  const std::string_view other = oscillating ? "rise" : "rise_deg";
  if (table.contains(other)) {
    table.know({other});
    table.fault(other, oscillating
                           ? "is a length, but the follower oscillates; expected rise_deg"
                           : "is an angle, but the follower translates; expected rise, a length");
    return std::nullopt;
  }
  const auto rise = table.number(key, oscillating ? kSwingAngle : kQuantity);
  if (table.has(key) && !rise) return std::nullopt;
  if (law == MotionLaw::dwell) {
    if (rise.value_or(0) == 0) return 0.0;
    table.fault(key,
                fmt::format("is {} in a dwell, which has none; expected another law, or 0", *rise));
    return std::nullopt;
  }
  if (has_fixed_places(law)) return rise.value_or(0);
  if (rise && *rise != 0) return rise;
  table.fault(key, fmt::format("is {}; expected {} in a rise, negative in a return, (law = "
                               "\"dwell\" stays where it is)",
                               rise ? "0" : "missing",
                               oscillating ? "the angle of the swing" : "the lift"));
  return std::nullopt;
}

struct Share {
  std::string_view key;
  MotionParameter parameter;
  double cam::UniversalShape<double>::*value;
};

constexpr Share kShares[] = {
    {"sine", MotionParameter::sine, &cam::UniversalShape<double>::sine},
    {"constant", MotionParameter::constant, &cam::UniversalShape<double>::constant},
    {"cosine", MotionParameter::cosine, &cam::UniversalShape<double>::cosine}};

std::optional<Range> read_share(TableReader& table, std::string_view key) {
  if (table.has_array(key)) return table.range(key, kAccelerationShare);
  const auto share = table.number(key, kAccelerationShare);
  if (table.has(key) && !share) return std::nullopt;
  return Range{share.value_or(0), share.value_or(0)};
}

// The middles of the ranges, or, where these are more than 1 together, as much less as they must
// be.
void place_shares(const std::array<Range, 3>& ranges, CamSegment& read) {
  double least = 0, middle = 0;
  for (const Range& range : ranges) {
    least += range.min;
    middle += (range.min + range.max) / 2;
  }
  const double part = middle > 1 ? std::max(0.0, (1 - least) / (middle - least)) : 1;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const auto& [min, max] = ranges[i];
    read.segment.shape.*kShares[i].value = min + part * (max - min) / 2;
    if (min < max) read.free_shares.push_back({0, kShares[i].parameter, ranges[i]});
  }
}

bool read_shape(TableReader& table, CamSegment& read) {
  std::array<Range, 3> ranges;
  double least = 0, most = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const auto share = read_share(table, kShares[i].key);
    if (!share) return false;
    ranges[i] = *share;
    least += share->min;
    most += share->max;
  }
  constexpr double kRounding = 1e-12;
  if (least > 1 + kRounding) {
    table.fault("sine", fmt::format("+ constant + cosine is {}{}; expected 1 at most, the rest "
                                    "is constant velocity",
                                    least < most ? "at least " : "", least));
    return false;
  }
  if (most == 0) {
    table.fault("sine",
                "+ constant + cosine is 0; expected shares of the segment in which the follower "
                "accelerates, of 1 together at most");
    return false;
  }
  place_shares(ranges, read);
  return true;
}

bool read_parameters(TableReader& table, bool oscillating, CamSegment& read) {
  switch (read.segment.law) {
    case MotionLaw::universal:
      return read_shape(table, read);
    case MotionLaw::polynomial:
      return read_conditions(table, oscillating, read.over_deg.max, read.segment);
    case MotionLaw::spline:
      return read_spline(table, oscillating, read.over_deg.max, read.segment);
    default:
      return true;
  }
}

// What other laws have, so that a fault of the law brings no others.
void know_all(TableReader& table) {
  table.know({"rise", "rise_deg", "sine", "constant", "cosine", "conditions", "points", "degree",
              "velocity", "acceleration", "periodic"});
}

}  // namespace

std::optional<CamSegment> read_cam_segment(TableReader& table, bool oscillating) {
  const auto law = read_law(table);
  const auto over = read_over(table, law);
  const auto rise = law ? read_rise(table, *law, oscillating) : std::nullopt;
  if (!law || !over || !rise) {
    know_all(table);
    table.finish();
    return std::nullopt;
  }
  CamSegment read;
  read.segment.law = *law;
  read.segment.over = radians(over->max);
  read.over_deg = *over;
  read.rise = *rise;
  read.segment.rise = oscillating ? radians(*rise) : *rise;
  const bool sound = read_parameters(table, oscillating, read);
  table.finish();
  return sound ? std::optional(std::move(read)) : std::nullopt;
}

}  // namespace cognate::problems::reading
