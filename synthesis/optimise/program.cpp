#include "synthesis/optimise/program.hpp"

#include <limits>

namespace cognate::synthesis {
namespace {

using Eigen::Index;
using Eigen::Map;
using Eigen::VectorXd;

Map<VectorXd> vector(std::span<double> out) {
  return {out.data(), static_cast<Index>(out.size())};
}

VectorXd with_level(const VectorXd& y, bool epigraph, double level) {
  VectorXd z(y.size() + (epigraph ? 1 : 0));
  z.head(y.size()) = y;
  if (epigraph) z[y.size()] = level;
  return z;
}

}  // namespace

Program::Program(DenseModel& model, Minimax form)
    : model_(model),
      epigraph_(model.minimax() && form == Minimax::epigraph),
      lower_(with_level(model.lower(), epigraph_, 0)),
      upper_(with_level(model.upper(), epigraph_, std::numeric_limits<double>::infinity())) {
  restart();
}

void Program::restart() {
  unit_ = model_.best_objective() > 0 ? model_.best_objective() : 1;
  start_ = with_level(model_.best(), epigraph_, model_.best_objective() / unit_);
}

bool Program::evaluate(std::span<const double> z, bool with_derivatives) {
  if (epigraph_) level_ = z.back();
  return model_.evaluate(z.first(model_.size()), with_derivatives);
}

double Program::objective() const {
  return epigraph_ ? level_ : model_.objective() / unit_;
}

void Program::gradient(std::span<double> out) const {
  if (epigraph_) {
    vector(out).setZero();
    out.back() = 1;
  } else {
    vector(out).noalias() = (2 / unit_) * (model_.jacobian().transpose() * model_.residuals());
  }
}

void Program::constraints(std::span<double> out) const {
  auto c = vector(out);
  c.head(model_.constraint_count()) = model_.constraints();
  if (!epigraph_) return;
  const Index rows = model_.residual_count();
  c.tail(rows).array() = level_ + model_.residuals().array() / unit_;
  c.segment(model_.constraint_count(), rows).array() = level_ - model_.residuals().array() / unit_;
}

bool Program::hessian(double of_objective, std::span<const double> of_constraints, RowMatrix& out) {
  const Map<const VectorXd> weights(of_constraints.data(), constraint_count());
  const Index limits = model_.constraint_count(), rows = model_.residual_count();
  VectorXd of_residuals;
  if (epigraph_) {
    of_residuals = (weights.tail(rows) - weights.segment(limits, rows)) / unit_;
  } else {
    of_residuals = (2 * of_objective / unit_) * model_.residuals();
  }
  RowMatrix curvature;
  if (!model_.hessian(of_residuals, weights.head(limits), curvature)) return false;
  out.setZero(size(), size());
  out.topLeftCorner(model_.size(), model_.size()) = curvature;
  if (!epigraph_) {
    out += (2 * of_objective / unit_) * model_.jacobian().transpose() * model_.jacobian();
  }
  return true;
}

void Program::constraint_jacobian(std::span<double> out) const {
  Map<RowMatrix> c(out.data(), constraint_count(), size());
  const Index n = model_.size();
  const Index limits = model_.constraint_count();
  c.topLeftCorner(limits, n) = model_.constraint_jacobian();
  if (!epigraph_) return;
  const Index rows = model_.residual_count();
  c.col(n).head(limits).setZero();
  c.col(n).tail(2 * rows).setOnes();
  c.block(limits, 0, rows, n) = -model_.jacobian() / unit_;
  c.bottomLeftCorner(rows, n) = model_.jacobian() / unit_;
}

}  // namespace cognate::synthesis
