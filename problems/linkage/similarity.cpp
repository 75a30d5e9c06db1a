#include "problems/linkage/similarity.hpp"

namespace cognate::problems {

void Similarity::shrink(std::optional<double>& length) const {
  if (length) *length /= size;
}

void Similarity::shrink(std::optional<Range>& lengths) const {
  if (lengths) lengths = Range{lengths->min / size, lengths->max / size};
}

void Similarity::shrink(std::optional<Box>& vectors) const {
  if (vectors) vectors = Box{(1 / size) * vectors->min, (1 / size) * vectors->max};
}

void Similarity::move(std::optional<Vec2d>& p) const {
  if (p) p = point(*p);
}

void Similarity::move(std::optional<Box>& box) const {
  if (box) box = Box{point(box->min), point(box->max)};
}

void Similarity::move(Given& given) const {
  for (auto* length : {&given.crank, &given.coupler, &given.rocker, &given.frame}) shrink(*length);
  move(given.pivot_a);
  move(given.pivot_d);
  if (given.coupler_point) given.coupler_point = (1 / size) * *given.coupler_point;
}

void Similarity::move(Bounds& bounds) const {
  for (auto* range : {&bounds.crank, &bounds.coupler, &bounds.rocker, &bounds.frame}) {
    shrink(*range);
  }
  move(bounds.pivot_a);
  move(bounds.pivot_d);
  shrink(bounds.coupler_point);
}

namespace {

void shrink_operation(Operation& operation, double size) {
  const double square = size * size;
  operation.flywheel /= square;
  for (LinkMass& link : operation.links) {
    link.mass_per_length *= size;
    link.moment /= square;
    link.centre.offset = (1 / size) * link.centre.offset;
  }
  for (WorkingLoad& load : operation.loads) {
    load.at.offset = (1 / size) * load.at.offset;
    load.force = (1 / size) * load.force;
    load.torque /= square;
  }
  operation.gravity = (1 / size) * operation.gravity;
}

}  // namespace

void Similarity::move(Constraints& constraints) const {
  move(constraints.pivot_region);
  for (Clearance& clearance : constraints.clearances) {
    clearance.box = {point(clearance.box.min), point(clearance.box.max)};
  }
  shrink(constraints.peak_acceleration_max);
  for (auto* of_energy : {&constraints.torque_ripple_max, &constraints.flywheel_inertia_max,
                          &constraints.motor_power_max}) {
    if (*of_energy) **of_energy /= size * size;
  }
  shrink_operation(constraints.operation, size);
}

}  // namespace cognate::problems
