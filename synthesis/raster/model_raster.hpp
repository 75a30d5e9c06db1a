/// @file A model some of whose variables lie on a raster, as the search on a raster takes it.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/optimise/model.hpp"
#include "synthesis/optimise/solver.hpp"
#include "synthesis/raster/raster.hpp"
#include "synthesis/search/deadline.hpp"

namespace cognate::synthesis {

/// Which global variable an axis is. A value of the axis is that of the variable: minus `offset`,
/// over `scale`, and of that the logarithm where `is_logarithm`.
struct AxisVariable {
  int variable = 0;
  double offset = 0, scale = 1;
  bool is_logarithm = false;

  double of_value(double value) const;
  double to_value(double variable) const;
};

/// `inner` within other bounds of its global variables, those whose bounds agree left out.
class RestrictedModel final : public Model {
 public:
  /// `inner` must outlive this object. One entry of the bounds for each global variable.
  RestrictedModel(const Model& inner, std::span<const double> lower, std::span<const double> upper);

  std::span<const Variable> variables() const override { return variables_; }
  int residual_count() const override { return inner_.residual_count(); }
  int constraint_count() const override { return inner_.constraint_count(); }
  int equality_count() const override { return inner_.equality_count(); }
  Objective objective() const override { return inner_.objective(); }
  std::span<const int> local_of_residual() const override { return inner_.local_of_residual(); }
  int local_count() const override { return inner_.local_count(); }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override;

  /// The variables of this model from those of `inner`, within bounds; and back.
  std::vector<double> inwards(std::span<const double> x) const;
  std::vector<double> outwards(std::span<const double> x) const;

 private:
  void pick_columns(std::span<const double> all, std::size_t rows, std::span<double> picked) const;

  const Model& inner_;
  std::vector<Variable> variables_;
  std::vector<std::size_t> free_;  ///< global variables of `inner`
  std::vector<double> fixed_;      ///< one for each global variable, of those that are not free
};

/// How minima within a box are found.
struct ModelRasterOptions {
  Solver solver = Solver::gauss_newton;
  double tolerance = 1e-10;
  int iterations = 100;
  double feasibility = 1e-9;
  /// Minima whose unknowns differ by no more, relative to 1 + |x|, are one.
  double same = 1e-5;
  const Deadline* deadline = nullptr;  ///< when minima are left where they are
};

/// One or several models (assemblies, classes) of the same axes. A point's form is the number of
/// its model, its x the variables.
class ModelRaster : public RasterTask {
 public:
  /// Each model has the variables of the axes at the same places.
  ModelRaster(std::vector<RasterAxis> axes, std::vector<AxisVariable> variables,
              std::vector<std::shared_ptr<const Model>> models, ModelRasterOptions options = {});

  std::span<const RasterAxis> axes() const override { return axes_; }
  std::vector<RasterPoint> relax(const RasterBox& box,
                                 std::span<const RasterPoint> from) const override;

  /// A point of a model at its variables, whether a minimum or not; not finite where it has no
  /// value.
  RasterPoint point(int form, std::vector<double> x) const;

  const Model& model(int form) const { return *models_[static_cast<std::size_t>(form)]; }

 protected:
  /// The variables of a model with those of the axes at a combination.
  void place(const RasterNumbers& at, std::span<double> x) const;
  /// What the variable of an axis is at a combination.
  double variable_at(const RasterNumbers& at, std::size_t axis) const {
    return variables_[axis].of_value(axes_[axis].values.at(at[axis]));
  }

  const std::vector<AxisVariable>& axis_variables() const { return variables_; }

 private:
  std::optional<RasterPoint> relaxed(const RasterBox& box, const RasterPoint& from) const;
  bool is_same(const RasterPoint& a, const RasterPoint& b) const;

  std::vector<RasterAxis> axes_;
  std::vector<AxisVariable> variables_;
  std::vector<std::shared_ptr<const Model>> models_;
  ModelRasterOptions options_;
};

}  // namespace cognate::synthesis
