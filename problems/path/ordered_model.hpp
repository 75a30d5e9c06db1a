/// @file Path generation as a nonlinear program of the linkage alone, its points kept in order.
#pragma once

#include <optional>
#include <vector>

#include "problems/path/model.hpp"
#include "problems/path/order.hpp"

namespace cognate::problems {

/// A path model whose untimed points lie, for each linkage, at the places that `PathOrder` finds:
/// the variables are the global ones of the model. No linkage has a defect of order or circuit, and
/// where its crank does not turn fully, untimed points satisfy the limits of the transmission
/// angle.
///
/// Derivatives are those of the residuals less what the places, were they free to move within their
/// blocks, would make up for (Kaufman 1975, "A variable projection method for solving separable
/// nonlinear least squares problems"): Jᵀr is the exact gradient, as the places are optimal, and
/// JᵀJ that of the Gauss–Newton method in all variables. Evaluations share memory: an object is for
/// one thread.
class OrderedPathModel final : public synthesis::Model {
 public:
  /// `scaled` as `model` was made of; `model` must outlive this object.
  OrderedPathModel(const PathProblem& scaled, const PathModel& model, bool clockwise);

  std::span<const synthesis::Variable> variables() const override {
    return model_.variables().first(globals_);
  }
  int residual_count() const override { return model_.residual_count(); }
  int constraint_count() const override { return model_.constraint_count(); }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override {
    model_.constraints(x, c, jacobian);
  }

  /// The variables of the path model whose global ones are those of `x`, and the places of the
  /// points there; empty where the linkage cannot pass them.
  struct Whole {
    std::vector<double> x;
    OrderedPlaces places;
  };
  std::optional<Whole> whole(std::span<const double> x) const;

 private:
  using Slopes = std::array<double, PathModel::dimensions>;
  const OrderedPlaces* place(std::span<const double> x) const;
  Slopes slopes_of(const PlaceInOrder& place, const Lengths<double>& links) const;
  void follow(const OrderedPlaces& places, const Lengths<double>& links,
              std::span<const double> local, std::span<double> jacobian) const;
  void project(const OrderedPlaces& places, std::span<const double> local,
               std::span<double> jacobian) const;

  const PathModel& model_;
  PathOrder order_;
  std::size_t globals_;
  bool clockwise_;
  bool counted_from_x_;  ///< timed angles are counted from the x axis, not the frame
  std::vector<std::size_t> untimed_;
  // Memory of evaluations, for one thread at a time.
  mutable PathOrderWorkspace workspace_;
  mutable std::vector<double> x_, angles_, local_, square_, along_;
};

}  // namespace cognate::problems
