#include "problems/linkage/similarity.hpp"

#include "problems/linkage/linkage_keys.hpp"

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
  for (const LinkKey& link : kLinkKeys) shrink(given.*link.given);
  move(given.pivot_a);
  move(given.pivot_d);
  if (given.coupler_point) given.coupler_point = (1 / size) * *given.coupler_point;
}

void Similarity::move(Bounds& bounds) const {
  for (const LinkKey& link : kLinkKeys) shrink(bounds.*link.bounds);
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
  for (const CycleDeclaration& quantity : kCycleQuantities) {
    auto& most = constraints.cycle_max[quantity.id];
    if (!most) continue;
    double scale = 1;
    for (int i = 0; i < quantity.length_power; ++i) scale *= size;
    *most /= scale;
  }
  shrink_operation(constraints.operation, size);
}

}  // namespace cognate::problems
