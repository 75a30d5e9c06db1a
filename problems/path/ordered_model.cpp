#include "problems/path/ordered_model.hpp"

#include <cmath>

#include "analysis/linkage/mobility.hpp"

namespace cognate::problems {

OrderedPathModel::OrderedPathModel(const PathProblem& scaled, const PathModel& model,
                                   bool clockwise)
    : model_(model),
      order_(scaled, model.transmission_on_the_way()),
      globals_(static_cast<std::size_t>(model.global_count())),
      clockwise_(clockwise),
      counted_from_x_(scaled.crank_reference == CrankReference::global) {
  for (std::size_t j = 0; j < scaled.points.size(); ++j) {
    if (!scaled.is_timed(j)) untimed_.push_back(j);
  }
  angles_.resize(scaled.points.size());
}

/// Finds the places, and with them all variables of the path model, which are in `x_`.
const OrderedPlaces* OrderedPathModel::place(std::span<const double> x) const {
  x_.assign(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(globals_));
  x_.resize(globals_ + untimed_.size());
  model_.crank_angles(x_, angles_);
  const auto* places = order_.places(model_.linkage(x_), angles_, clockwise_, workspace_);
  if (!places) return nullptr;
  for (std::size_t k = 0; k < untimed_.size(); ++k) {
    x_[globals_ + k] = places->of_point[untimed_[k]].angle;
  }
  return places;
}

std::optional<OrderedPathModel::Whole> OrderedPathModel::whole(std::span<const double> x) const {
  const OrderedPlaces* places = place(x);
  if (!places) return std::nullopt;
  return Whole{x_, *places};
}

bool OrderedPathModel::residuals(std::span<const double> x, std::span<double> r,
                                 std::span<double> jacobian, std::span<double>) const {
  const OrderedPlaces* places = place(x);
  if (!places) return false;
  if (jacobian.empty()) return model_.residuals(x_, r, {}, {});
  local_.assign(r.size(), 0);
  if (!model_.residuals(x_, r, jacobian, local_)) return false;
  follow(*places, lengths(model_.linkage(x_)), local_, jacobian);
  project(*places, local_, jacobian);
  return true;
}

/// What the angle that holds a point, from the frame line, changes by with each dimension. At an
/// end of the crank's range μ stays as it is, with BD² = l₂² + l₃² − 2 l₂ l₃ cos μ and
/// cos θ = (l₁² + l₄² − BD²)/(2 l₁ l₄).
OrderedPathModel::Slopes OrderedPathModel::slopes_of(const PlaceInOrder& place,
                                                     const Lengths<double>& links) const {
  Slopes slopes{};
  if (place.held_by == HeldBy::timed_point) {
    slopes[counted_from_x_ ? PathModel::angle : PathModel::phase] = counted_from_x_ ? -1 : 1;
    return slopes;
  }
  const auto& [l1, l2, l3, l4] = links;
  const double cosine = std::cos(place.angle), sine = std::sin(place.angle);
  const double square = (l4 - l1 * cosine) * (l4 - l1 * cosine) + l1 * sine * l1 * sine;
  const double cos_mu = (l2 * l2 + l3 * l3 - square) / (2 * l2 * l3);
  slopes[PathModel::crank] = (cosine / l1 - 1 / l4) / sine;
  slopes[PathModel::frame] = (cosine / l4 - 1 / l1) / sine;
  slopes[PathModel::coupler] = (l2 - l3 * cos_mu) / (l1 * l4 * sine);
  slopes[PathModel::rocker] = (l3 - l2 * cos_mu) / (l1 * l4 * sine);
  return slopes;
}

/// Points that are held where the crank's range ends, or by a timed point, go with those.
void OrderedPathModel::follow(const OrderedPlaces& places, const Lengths<double>& links,
                              std::span<const double> local, std::span<double> jacobian) const {
  const auto dimensions = model_.free_dimensions();
  for (const std::size_t j : untimed_) {
    const PlaceInOrder& place = places.of_point[j];
    if (place.held_by == HeldBy::nothing) continue;
    const Slopes slopes = slopes_of(place, links);
    for (std::size_t row = 2 * j; row < 2 * j + 2; ++row) {
      for (std::size_t i = 0; i < globals_; ++i) {
        jacobian[row * globals_ + i] +=
            local[row] * slopes[static_cast<std::size_t>(dimensions[i])];
      }
    }
  }
}

/// Takes from the rows of each block what lies along its own derivative.
void OrderedPathModel::project(const OrderedPlaces& places, std::span<const double> local,
                               std::span<double> jacobian) const {
  std::vector<double>&square = square_, &along = along_;
  square.assign(places.blocks, 0);
  along.assign(places.blocks * globals_, 0);
  const auto over_rows = [&](const auto& act) {
    for (const std::size_t j : untimed_) {
      const PlaceInOrder& place = places.of_point[j];
      if (place.held_by != HeldBy::nothing) continue;
      act(place.block, 2 * j);
      act(place.block, 2 * j + 1);
    }
  };
  over_rows([&](std::size_t block, std::size_t row) {
    square[block] += local[row] * local[row];
    for (std::size_t i = 0; i < globals_; ++i) {
      along[block * globals_ + i] += local[row] * jacobian[row * globals_ + i];
    }
  });
  over_rows([&](std::size_t block, std::size_t row) {
    if (square[block] == 0) return;
    const double share = local[row] / square[block];
    for (std::size_t i = 0; i < globals_; ++i) {
      jacobian[row * globals_ + i] -= share * along[block * globals_ + i];
    }
  });
}

}  // namespace cognate::problems
