#include "analysis/mechanism/assembly_probe.hpp"

#include <iterator>

#include "analysis/mechanism/convert.hpp"

namespace cognate {
namespace {

/// Slides closer than this sine to parallel do not count as crossing.
constexpr double kLeastSine = 1e-12;

DrivePosition<Dual> dual_drive(const Mechanism<double>& mechanism, double drive) {
  const DrivePosition<double> at = drive_position(mechanism, drive);
  return {{{at.direction.x, -at.direction.y}, {at.direction.y, at.direction.x}},
          {at.displacement, 1}};
}

}  // namespace

AssemblyProbe::AssemblyProbe(const Mechanism<double>& mechanism)
    : mechanism_(mechanism),
      dyads_(convert<Dual>(mechanism).dyads),
      dual_(convert<Dual>(mechanism)),
      sides_(mechanism.dyads.size()),
      dual_sides_(mechanism.dyads.size()),
      bodies_(static_cast<std::size_t>(body_count(mechanism))),
      places_(bodies_.size()),
      closures_(mechanism.dyads.size()) {}

void AssemblyProbe::keep_to(int index) {
  const auto count = index + 1;
  if (std::ssize(dual_.dyads) == count) return;
  dual_.dyads.assign(dyads_.begin(), dyads_.begin() + count);
}

const DyadClosure<Dual>& AssemblyProbe::closure(const AssemblyRange& run, double drive, int index) {
  sides_or_none_at(run, drive, sides_);
  return evaluate_at(run, drive, index);
}

const DyadClosure<Dual>& AssemblyProbe::evaluate_at(const AssemblyRange& run, double drive,
                                                    int index) {
  for (std::size_t i = 0; i < sides_.size(); ++i) dual_sides_[i] = Dual(sides_[i]);
  keep_to(index);
  place_groups(run, drive, std::span(bodies_));
  evaluate<0>(dual_, dual_drive(mechanism_, drive), dual_sides_, bodies_, closures_);
  return closures_[static_cast<std::size_t>(index)];
}

Reach AssemblyProbe::dyad_reach(const AssemblyRange& run, double drive, int index) {
  sides_at(run, drive, sides_);
  evaluate_at(run, drive, index);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const BodyMotion<Dual, 0>& body = bodies_[i];
    places_[i].direction = {body.direction.x.value, body.direction.y.value};
    places_[i].origin[0] = {body.origin[0].x.value, body.origin[0].y.value};
  }
  return reach(dyad(index), places_, drive);
}

Closeness AssemblyProbe::closeness(const AssemblyRange& run, double drive, int index) {
  const Reach reach = dyad_reach(run, drive, index);
  const Dual& discriminant = closures_[static_cast<std::size_t>(index)].discriminant;
  if (reach.is_sine) return {discriminant.value - kLeastSine * kLeastSine, discriminant.rate, 0};
  return {discriminant.value, discriminant.rate, discriminant_rounding(mechanism_, index, reach)};
}

}  // namespace cognate
