#include "problems/tolerance/dimensions.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <variant>

#include "analysis/mechanism/kinematics.hpp"
#include "problems/mechanism/mechanism_types.hpp"
#include "problems/mechanism/read_whole_mechanism.hpp"
#include "problems/mechanism/write_mechanism.hpp"

namespace cognate::problems {
namespace {

constexpr std::string_view kPivots = "pivots", kFrame = "frame";
constexpr double kMillimetresInMetre = 1000;

/// Collects the dimensions that the keys of a type hold.
template <class Type>
class KeyDimensions {
 public:
  KeyDimensions(const Type& type, std::string_view key, std::vector<MechanismDimension>& all)
      : type_(type), key_(key), all_(all) {}

  void operator()(const LengthKey<Type>& length) const {
    add_number(length.of);
    all_.back().is_length = true;
  }
  void operator()(const OffsetKey<Type>& offset) const { add_number(offset.of); }
  void operator()(const NonzeroKey<Type>& offset) const { add_number(offset.of); }
  void operator()(const PlaceKey<Type>& place) const {
    add_place(place.of, key_, std::string(kPivots));
  }
  void operator()(const PivotsKey<Type>& pivots) const {
    const Vec2d along = type_.*pivots.second - type_.*pivots.first;
    const double frame = norm(along);
    const Vec2d direction = (1 / frame) * along;
    add(std::string(kFrame), std::string(kFrame), frame,
        [of = pivots.second, direction](Type& type, double change) {
          type.*of = type.*of + change * direction;
        });
    all_.back().is_length = true;
    add_place(pivots.first, "A", std::string(kPivots));
    add_place(pivots.second, "D", std::string(kPivots));
  }
  void operator()(const PointKey<Type>& point) const {
    if (!(type_.*point.of)) return;
    const Vec2d at = *(type_.*point.of);
    add(key_ + ".u", key_, at.x,
        [of = point.of](Type& type, double change) { (type.*of)->x += change; });
    add(key_ + ".v", key_, at.y,
        [of = point.of](Type& type, double change) { (type.*of)->y += change; });
  }
  void operator()(const DirectionKey<Type>& /*exact*/) const {}
  void operator()(const InclinationKey<Type>& /*exact*/) const {}
  void operator()(const AssemblyKey<Type>& /*no dimension*/) const {}

 private:
  template <class Add>
  void add(std::string name, std::string group, double nominal, Add change_by) const {
    all_.push_back({std::move(name), std::move(group), nominal,
                    [change_by](NamedMechanism& mechanism, double change) {
                      change_by(std::get<Type>(mechanism.description), change);
                    }});
  }
  void add_number(double Type::*of) const {
    add(key_, key_, type_.*of, [of](Type& type, double change) { type.*of += change; });
  }
  void add_place(Vec2d Type::*of, const std::string& name, const std::string& group) const {
    const Vec2d at = type_.*of;
    add(name + ".x", group, at.x, [of](Type& type, double change) { (type.*of).x += change; });
    add(name + ".y", group, at.y, [of](Type& type, double change) { (type.*of).y += change; });
  }

  const Type& type_;
  std::string key_;
  std::vector<MechanismDimension>& all_;
};

template <class Type>
void add_dimensions(const Type& type, std::vector<MechanismDimension>& all) {
  for (const auto& key : TypeTraits<Type>::kKeys) {
    std::visit(KeyDimensions<Type>(type, key.name, all), key.holds);
  }
}

/// Of a chain: `of(chain)` is the number.
template <class Of>
void add_number(std::string name, const ChainDescription& chain, const Of& of,
                std::vector<MechanismDimension>& all, std::string_view group = {}) {
  ChainDescription copy = chain;
  const double nominal = of(copy);
  std::string called = group.empty() ? name : std::string(group);
  all.push_back(
      {std::move(name), std::move(called), nominal, [of](NamedMechanism& mechanism, double change) {
         of(std::get<ChainDescription>(mechanism.description)) += change;
       }});
}

void add_dyad(const ChainDescription& chain, std::size_t d, std::vector<MechanismDimension>& all) {
  const DyadDescription& dyad = chain.dyads[d];
  for (std::size_t k = 0; k < dyad.lengths.size(); ++k) {
    add_number(
        dyad.names[k], chain,
        [d, k](ChainDescription& of) -> double& { return of.dyads[d].lengths[k]; }, all);
    all.back().is_length = true;
  }
  if (dyad.type == DyadType::rpr) {
    add_number(
        dyad.names[1], chain, [d](ChainDescription& of) -> double& { return of.dyads[d].offset; },
        all);
  }
  for (std::size_t k = 0; k < dyad.slides.size(); ++k) {
    add_number(
        dyad.names[dyad.slides.size() == 2 ? k : 1], chain,
        [d, k](ChainDescription& of) -> double& { return of.dyads[d].slides[k].offset; }, all);
  }
}

void add_dimensions(const ChainDescription& chain, std::vector<MechanismDimension>& all) {
  if (const auto* crank = std::get_if<CrankDescription>(&chain.drive)) {
    add_number(
        crank->name, chain,
        [](ChainDescription& of) -> double& { return std::get<CrankDescription>(of.drive).length; },
        all);
    all.back().is_length = true;
  } else if (const auto* cylinder = std::get_if<CylinderDescription>(&chain.drive)) {
    add_number(
        cylinder->names[2], chain,
        [](ChainDescription& of) -> double& {
          return std::get<CylinderDescription>(of.drive).length;
        },
        all);
    all.back().is_length = true;
  } else {
    add_number(
        std::get<SliderDescription>(chain.drive).name, chain,
        [](ChainDescription& of) -> double& {
          return std::get<SliderDescription>(of.drive).slide.offset;
        },
        all);
  }
  for (std::size_t d = 0; d < chain.dyads.size(); ++d) add_dyad(chain, d, all);
  for (std::size_t k = 0; k < chain.pivots.size(); ++k) {
    const std::string& name = chain.pivots[k].name;
    add_number(
        name + ".x", chain, [k](ChainDescription& of) -> double& { return of.pivots[k].at.x; }, all,
        kPivots);
    add_number(
        name + ".y", chain, [k](ChainDescription& of) -> double& { return of.pivots[k].at.y; }, all,
        kPivots);
  }
}

void add_extra_points(const NamedMechanism& mechanism, std::vector<MechanismDimension>& all) {
  for (std::size_t k = 0; k < mechanism.extra_points.size(); ++k) {
    const auto& [name, on, at] = mechanism.extra_points[k];
    all.push_back({name + ".u", name, at.x,
                   [k](NamedMechanism& of, double change) { of.extra_points[k].at.x += change; }});
    all.push_back({name + ".v", name, at.y,
                   [k](NamedMechanism& of, double change) { of.extra_points[k].at.y += change; }});
  }
}

MechanismWithPoints<double> with_points(const NamedMechanism& mechanism) {
  MechanismWithPoints<double> all{mechanism.mechanism, {}};
  for (const NamedPoint& point : mechanism.points) all.points.push_back(point.at);
  return all;
}

/// All numbers of the mechanism that the description of `mechanism` tells, as a file's is read, its
/// points in the order of `mechanism`; empty where that is none.
std::vector<double> numbers_of(const NamedMechanism& mechanism) {
  using namespace reading;
  const Table table = mechanism_writer(mechanism).take();
  const Table nothing;
  FaultList faults;
  TableReader document(nothing, faults);
  TableReader keys(table, faults);
  const auto read = read_whole_mechanism(document, keys);
  if (!read || faults.size() > 0) return {};
  MechanismWithPoints<double> all{read->mechanism.mechanism, {}};
  for (const NamedPoint& point : mechanism.points) {
    const auto& points = read->mechanism.points;
    const auto same = std::ranges::find(points, point.name, &NamedPoint::name);
    if (same == points.end()) return {};
    all.points.push_back(same->at);
  }
  return AffineMechanism::numbers(all);
}

/// How each number grows with `dimension`; empty where it is no multiple of its change.
std::vector<double> slopes_of(const NamedMechanism& mechanism, const MechanismDimension& dimension,
                              const std::vector<double>& nominal) {
  constexpr double kSame = 1e-12;
  double size = std::abs(dimension.nominal);
  for (const double number : nominal) size = std::max(size, std::abs(number));
  const double step = std::exp2(std::floor(std::log2(size)));
  const auto moved = [&](double change) {
    NamedMechanism changed = mechanism;
    dimension.add(changed, change);
    return numbers_of(changed);
  };
  const std::vector<double> once = moved(step), twice = moved(2 * step);
  if (once.size() != nominal.size() || twice.size() != nominal.size()) return {};
  std::vector<double> slopes;
  for (std::size_t i = 0; i < nominal.size(); ++i) {
    const double slope = (once[i] - nominal[i]) / step;
    if (!(std::abs((twice[i] - nominal[i]) / step - 2 * slope) <= kSame)) return {};
    const double whole = std::round(slope);
    slopes.push_back(std::abs(slope - whole) <= kSame ? whole : slope);
  }
  return slopes;
}

/// The tolerance that the file gives `dimension`; none where it gives none.
const ToleranceValue* tolerance_of(const MechanismDimension& dimension,
                                   const Tolerances& tolerances) {
  const auto named =
      std::ranges::find(tolerances.dimensions, dimension.group, &NamedTolerance::dimension);
  if (named != tolerances.dimensions.end()) return &named->value;
  const bool is_pivot = dimension.group == kPivots;
  if (dimension.group == kFrame && tolerances.pivots) return nullptr;
  const auto& general = is_pivot ? tolerances.pivots : tolerances.length;
  return general ? &*general : nullptr;
}

tl::unexpected<ImpossibleTolerance> impossible(std::string group, std::string reason) {
  return tl::unexpected(ImpossibleTolerance{std::move(group), std::move(reason)});
}

}  // namespace

std::vector<MechanismDimension> dimensions(const NamedMechanism& mechanism) {
  std::vector<MechanismDimension> all;
  std::visit([&](const auto& described) { add_dimensions(described, all); }, mechanism.description);
  add_extra_points(mechanism, all);
  return all;
}

std::vector<std::string> dimension_groups(const NamedMechanism& mechanism) {
  std::vector<std::string> groups;
  for (const MechanismDimension& dimension : dimensions(mechanism)) {
    if (dimension.group == kPivots) continue;
    if (std::ranges::find(groups, dimension.group) == groups.end()) {
      groups.push_back(dimension.group);
    }
  }
  return groups;
}

tl::expected<Deviation, std::string> deviation_of(const std::string& name, double nominal,
                                                  const ToleranceValue& value,
                                                  std::optional<LengthUnit> unit) {
  if (const auto* deviation = std::get_if<Deviation>(&value)) return *deviation;
  const auto grade = std::get<ToleranceGrade>(value);
  const double millimetres = unit ? kMillimetresInMetre * metres(unit) : 1;
  const double length = std::abs(nominal) * millimetres;
  if (length == 0) return Deviation{};  // a place on an axis has no size
  const auto deviation = deviation_mm(grade, length);
  if (!deviation) {
    return tl::unexpected(fmt::format(
        "{} is {:.6g} mm long, for which {} has no tolerance; it has them for lengths {}", name,
        length, to_string(grade), sizes_of(grade)));
  }
  return Deviation{*deviation / millimetres, *deviation / millimetres};
}

std::optional<std::string> nothing_left(const TolerancedDimension& dimension) {
  const auto& [name, nominal, deviation, is_length] = dimension;
  if (!is_length || deviation.minus < nominal || !(nominal > 0)) return std::nullopt;
  return fmt::format(
      "{} is {:.6g} long, of which a tolerance of -{:.6g} leaves nothing; expected less", name,
      nominal, deviation.minus);
}

tl::expected<TolerancedMechanism, ImpossibleTolerance> toleranced(const NamedMechanism& mechanism,
                                                                  const Tolerances& tolerances,
                                                                  std::optional<LengthUnit> unit) {
  TolerancedMechanism result;
  const MechanismWithPoints<double> whole = with_points(mechanism);
  const std::vector<double> nominal = AffineMechanism::numbers(whole);
  if (numbers_of(mechanism).size() != nominal.size()) {
    return impossible(
        "", "this mechanism cannot be written as a file, by which its dimensions are known");
  }
  std::vector<std::vector<double>> slopes;
  for (const MechanismDimension& dimension : dimensions(mechanism)) {
    const ToleranceValue* value = tolerance_of(dimension, tolerances);
    if (!value) continue;
    const auto deviation = deviation_of(dimension.name, dimension.nominal, *value, unit);
    if (!deviation) return impossible(dimension.group, deviation.error());
    if (deviation->plus == 0 && deviation->minus == 0) continue;
    const TolerancedDimension own{dimension.name, dimension.nominal, *deviation,
                                  dimension.is_length};
    if (auto reason = nothing_left(own)) return impossible(dimension.group, std::move(*reason));
    slopes.push_back(slopes_of(mechanism, dimension, nominal));
    if (slopes.back().empty()) {
      return impossible(
          dimension.group,
          fmt::format("{} turns the axes in which a point is given; give that point in the axes of "
                      "its body, or {} no tolerance",
                      dimension.name, dimension.group));
    }
    result.dimensions.push_back(own);
  }
  result.mechanism = AffineMechanism(whole, slopes);
  return result;
}

}  // namespace cognate::problems
