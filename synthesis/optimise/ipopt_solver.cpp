#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>
#include <algorithm>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

#include "synthesis/optimise/backends.hpp"
#include "synthesis/optimise/program.hpp"

namespace cognate::synthesis {
namespace {

using Ipopt::Index;
using Ipopt::Number;

constexpr double kInfinity = 1e19;  ///< what Ipopt takes for no bound
constexpr int kMostRounds = 3;

/// A program in the words of Ipopt, its matrices dense.
class Tnlp final : public Ipopt::TNLP {
 public:
  explicit Tnlp(Program& program) : program_(program) {}

  bool get_nlp_info(Index& n, Index& m, Index& nnz_jac, Index& nnz_hess,
                    IndexStyleEnum& style) override {
    n = program_.size();
    m = program_.constraint_count();
    nnz_jac = n * m;
    nnz_hess = 0;  // approximated
    style = TNLP::C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* lower, Number* upper, Index m, Number* c_lower,
                       Number* c_upper) override {
    for (Index i = 0; i < n; ++i) {
      lower[i] = std::max(program_.lower()[i], -kInfinity);
      upper[i] = std::min(program_.upper()[i], kInfinity);
    }
    std::fill_n(c_lower, m, 0.0);
    std::fill_n(c_upper, m, kInfinity);
    return true;
  }

  bool get_starting_point(Index n, bool, Number* z, bool, Number*, Number*, Index, bool,
                          Number*) override {
    std::copy_n(program_.start().data(), n, z);
    return true;
  }

  bool eval_f(Index n, const Number* z, bool, Number& value) override {
    if (!program_.evaluate(view(z, n), false)) return false;
    value = program_.objective();
    return true;
  }

  bool eval_grad_f(Index n, const Number* z, bool, Number* gradient) override {
    if (!program_.evaluate(view(z, n), true)) return false;
    program_.gradient(view(gradient, n));
    return true;
  }

  bool eval_g(Index n, const Number* z, bool, Index m, Number* c) override {
    if (!program_.evaluate(view(z, n), false)) return false;
    program_.constraints(view(c, m));
    return true;
  }

  bool eval_jac_g(Index n, const Number* z, bool, Index m, Index entries, Index* row, Index* column,
                  Number* values) override {
    if (values == nullptr) {
      for (Index i = 0, k = 0; i < m; ++i) {
        for (Index j = 0; j < n; ++j, ++k) {
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

  bool intermediate_callback(Ipopt::AlgorithmMode, Index iteration, Number, Number, Number, Number,
                             Number, Number, Number, Number, Index, const Ipopt::IpoptData*,
                             Ipopt::IpoptCalculatedQuantities*) override {
    outcome_.iterations = iteration;
    limit_ = program_.model().must_stop();
    return !limit_;
  }

  void finalize_solution(Ipopt::SolverReturn, Index, const Number*, const Number*, const Number*,
                         Index, const Number*, const Number* multipliers, Number,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    // Ipopt's Lagrangian is f + λᵀc with λ ≤ 0 for c ≥ 0.
    for (int i = 0; i < program_.model().constraint_count(); ++i) {
      outcome_.multipliers.push_back(-multipliers[i] * program_.unit());
    }
  }

  Outcome outcome(Ipopt::ApplicationReturnStatus status) const;

 private:
  template <class T>
  static std::span<T> view(T* data, Index size) {
    return {data, static_cast<std::size_t>(size)};
  }

  Program& program_;
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

void set_options(Ipopt::OptionsList& list, const Options& options) {
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
  // JᵀJ in place of the Hessian is four times faster on small residuals, and fails where residuals
  // or multipliers are large (Freudenstein-Roth, Hock-Schittkowski 43).
  list.SetStringValue("hessian_approximation", "limited-memory");
}

/// Ipopt with MUMPS holds global state: one solve at a time in a process.
std::mutex& ipopt_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// One run from the start of the program.
Outcome run(Program& program, const Options& options) {
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
  set_options(*application->Options(), options);
  if (application->Initialize("") != Ipopt::Solve_Succeeded) return {};
  const Ipopt::SmartPtr<Tnlp> tnlp = new Tnlp(program);
  const auto status = application->OptimizeTNLP(Ipopt::GetRawPtr(tnlp));
  return tnlp->outcome(status);
}

}  // namespace

Outcome minimise_with_ipopt(DenseModel& model, const Options& options) {
  const std::lock_guard lock(ipopt_mutex());
  Program program(model);
  Options left = options;
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
    Outcome polished = run(program, left);
    polished.iterations += outcome.iterations;
    if (polished.stop == Stop::failed) polished.stop = Stop::converged;  // as it was before
    outcome = std::move(polished);
  }
  return outcome;
}

}  // namespace cognate::synthesis
