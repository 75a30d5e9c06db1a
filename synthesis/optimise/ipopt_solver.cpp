#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>
#include <algorithm>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

#include "synthesis/optimise/foreign_solvers.hpp"
#include "synthesis/optimise/program.hpp"

namespace cognate::synthesis {
namespace {

using Ipopt::Number;

constexpr double kNoBound = 1e19;  ///< what Ipopt takes for no bound
constexpr int kMostRounds = 3;

/// A program in the words of Ipopt, its matrices dense.
class Tnlp final : public Ipopt::TNLP {
 public:
  /// `multipliers`: of the model's constraints, for a warm start; else empty.
  Tnlp(Program& program, std::span<const double> multipliers)
      : program_(program), multipliers_(multipliers) {}

  bool get_nlp_info(Ipopt::Index& n, Ipopt::Index& m, Ipopt::Index& nnz_jac, Ipopt::Index& nnz_hess,
                    IndexStyleEnum& style) override {
    n = program_.size();
    m = program_.constraint_count();
    nnz_jac = n * m;
    nnz_hess = n * (n + 1) / 2;  // the lower triangle, unused where it is approximated
    style = TNLP::C_STYLE;
    return true;
  }

  bool get_bounds_info(Ipopt::Index n, Number* lower, Number* upper, Ipopt::Index m,
                       Number* c_lower, Number* c_upper) override {
    for (Ipopt::Index i = 0; i < n; ++i) {
      lower[i] = std::max(program_.lower()[i], -kNoBound);
      upper[i] = std::min(program_.upper()[i], kNoBound);
    }
    std::fill_n(c_lower, m, 0.0);
    std::fill_n(c_upper, m, kNoBound);
    std::fill_n(c_upper, program_.equality_count(), 0.0);
    return true;
  }

  bool get_starting_point(Ipopt::Index n, bool, Number* z, bool with_bounds, Number* of_lower,
                          Number* of_upper, Ipopt::Index m, bool with_constraints,
                          Number* of_constraints) override {
    std::copy_n(program_.start().data(), n, z);
    if (with_bounds) {
      std::fill_n(of_lower, n, 0.0);
      std::fill_n(of_upper, n, 0.0);
    }
    for (Ipopt::Index i = 0; with_constraints && i < m; ++i) {
      of_constraints[i] = -multipliers_[i] / program_.unit();
    }
    return true;
  }

  bool eval_f(Ipopt::Index n, const Number* z, bool, Number& value) override {
    if (!program_.evaluate(view(z, n), false)) return false;
    value = program_.objective();
    return true;
  }

  bool eval_grad_f(Ipopt::Index n, const Number* z, bool, Number* gradient) override {
    if (!program_.evaluate(view(z, n), true)) return false;
    program_.gradient(view(gradient, n));
    return true;
  }

  bool eval_g(Ipopt::Index n, const Number* z, bool, Ipopt::Index m, Number* c) override {
    if (!program_.evaluate(view(z, n), false)) return false;
    program_.constraints(view(c, m));
    return true;
  }

  bool eval_jac_g(Ipopt::Index n, const Number* z, bool, Ipopt::Index m, Ipopt::Index entries,
                  Ipopt::Index* row, Ipopt::Index* column, Number* values) override {
    if (values == nullptr) {
      for (Ipopt::Index i = 0, k = 0; i < m; ++i) {
        for (Ipopt::Index j = 0; j < n; ++j, ++k) {
          row[k] = i;
          column[k] = j;
        }
      }
      return true;
    }
    if (!program_.evaluate(view(z, n), true)) return false;
    program_.constraint_jacobian(view(values, entries));
    return true;
  }

  bool eval_h(Ipopt::Index n, const Number* z, bool, Number of_objective, Ipopt::Index m,
              const Number* of_constraints, bool, Ipopt::Index, Ipopt::Index* row,
              Ipopt::Index* column, Number* values) override {
    if (values != nullptr) {
      if (!program_.evaluate(view(z, n), true)) return false;
      if (!program_.hessian(of_objective, view(of_constraints, m), hessian_)) return false;
    }
    for (Ipopt::Index i = 0, k = 0; i < n; ++i) {
      for (Ipopt::Index j = 0; j <= i; ++j, ++k) {
        if (values != nullptr) {
          values[k] = hessian_(i, j);
        } else {
          row[k] = i;
          column[k] = j;
        }
      }
    }
    return true;
  }

  bool intermediate_callback(Ipopt::AlgorithmMode, Ipopt::Index iteration, Number, Number, Number,
                             Number, Number, Number, Number, Number, Ipopt::Index,
                             const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    outcome_.iterations = iteration;
    limit_ = program_.model().must_stop();
    return !limit_;
  }

  void finalize_solution(Ipopt::SolverReturn, Ipopt::Index, const Number*, const Number*,
                         const Number*, Ipopt::Index, const Number*, const Number* multipliers,
                         Number, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    // Ipopt's Lagrangian is f + λᵀc with λ ≤ 0 for c ≥ 0.
    for (int i = 0; i < program_.model().constraint_count(); ++i) {
      outcome_.multipliers.push_back(-multipliers[i] * program_.unit());
    }
  }

  Outcome outcome(Ipopt::ApplicationReturnStatus status) const;

 private:
  template <class T>
  static std::span<T> view(T* data, Ipopt::Index size) {
    return {data, static_cast<std::size_t>(size)};
  }

  Program& program_;
  std::span<const double> multipliers_;
  RowMatrix hessian_;
  std::optional<Stop> limit_;
  Outcome outcome_;
};

Outcome Tnlp::outcome(Ipopt::ApplicationReturnStatus status) const {
  Outcome out = outcome_;
  switch (status) {
    case Ipopt::Solve_Succeeded:
    case Ipopt::Solved_To_Acceptable_Level:
    case Ipopt::Feasible_Point_Found:
    case Ipopt::Search_Direction_Becomes_Too_Small:
      out.stop = Stop::converged;
      break;
    case Ipopt::Infeasible_Problem_Detected:
      out.stop = Stop::infeasible;
      break;
    case Ipopt::Maximum_Iterations_Exceeded:
      out.stop = Stop::iteration_limit;
      break;
    default:
      out.stop = Stop::failed;
  }
  if (limit_) out.stop = *limit_;
  return out;
}

void set_options(Ipopt::OptionsList& list, const Options& options, bool exact_hessian) {
  list.SetStringValue("sb", "yes");
  list.SetIntegerValue("print_level", 0);
  list.SetIntegerValue("max_iter", options.max_iterations);
  list.SetStringValue("nlp_scaling_method", "none");  // the program is scaled already
  list.SetNumericValue("bound_relax_factor", 0);
  list.SetNumericValue("tol", 1e-11);
  list.SetNumericValue("constr_viol_tol", options.feasibility);
  // Stagnation: fifteen iterations in which a feasible objective changes by rounding only. Where
  // variables are badly scaled the gradient may stay far above `tol` then.
  list.SetNumericValue("acceptable_tol", 1e-4);
  list.SetNumericValue("acceptable_constr_viol_tol", options.feasibility);
  list.SetNumericValue("acceptable_compl_inf_tol", 1e-10);
  list.SetNumericValue("acceptable_obj_change_tol", options.tolerance);
  // Where the model has no second derivatives: JᵀJ in place of the Hessian is four times faster on
  // small residuals, and fails where residuals or multipliers are large (Freudenstein-Roth,
  // Hock-Schittkowski 43).
  list.SetStringValue("hessian_approximation", exact_hessian ? "exact" : "limited-memory");
}

/// The barrier begins small and the start is hardly pushed off its bounds.
void set_warm_start(Ipopt::OptionsList& list) {
  list.SetStringValue("warm_start_init_point", "yes");
  list.SetNumericValue("mu_init", 1e-6);
  for (const char* name :
       {"warm_start_bound_push", "warm_start_bound_frac", "warm_start_slack_bound_push",
        "warm_start_slack_bound_frac", "warm_start_mult_bound_push"}) {
    list.SetNumericValue(name, 1e-8);
  }
}

/// Ipopt with MUMPS holds global state: one solve at a time in a process.
std::mutex& ipopt_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// One run from the start of the program.
Outcome run(Program& program, const Options& options) {
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
  set_options(*application->Options(), options, program.model().has_hessian());
  if (!options.multipliers.empty()) set_warm_start(*application->Options());
  if (application->Initialize("") != Ipopt::Solve_Succeeded) return {};
  const Ipopt::SmartPtr<Tnlp> tnlp = new Tnlp(program, options.multipliers);
  const auto status = application->OptimizeTNLP(Ipopt::GetRawPtr(tnlp));
  return tnlp->outcome(status);
}

}  // namespace

Outcome minimise_with_ipopt(DenseModel& model, const Options& options) {
  const std::lock_guard lock(ipopt_mutex());
  Program program(model);
  Options left = options;
  const bool warm = !program.epigraph() && std::ssize(left.multipliers) == model.constraint_count();
  if (!warm) left.multipliers = {};
  Outcome outcome = run(program, left);
  // Ipopt's tolerances are relative to the objective at the start: where the objective has fallen
  // far below that, they are coarse, and another run is made in the new unit. Where nothing is left
  // but rounding it would find no descent.
  const double rounding = 1e-16 * program.unit();
  for (int round = 1; round < kMostRounds; ++round) {
    left.max_iterations = options.max_iterations - outcome.iterations;
    if (outcome.stop != Stop::converged || left.max_iterations <= 0) break;
    const double objective = model.best_objective();
    if (objective > 0.1 * program.unit() || objective <= rounding) break;
    program.restart();
    left.multipliers = {};
    Outcome polished = run(program, left);
    polished.iterations += outcome.iterations;
    if (polished.stop == Stop::failed) polished.stop = Stop::converged;  // as it was before
    outcome = std::move(polished);
  }
  return outcome;
}

}  // namespace cognate::synthesis
