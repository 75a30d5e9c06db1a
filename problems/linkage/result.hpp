/// @file What solving a problem gives: designs, what they reach and miss, and the work it took.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/vec2.hpp"
#include "problems/basics/names.hpp"
#include "problems/basics/quantity.hpp"
#include "problems/layers/layers.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/tolerance/result.hpp"
#include "synthesis/search/deadline.hpp"

namespace cognate::problems {

/// p → shift + scale·R(turn) p, without mirroring.
struct CurvePlacement {
  double scale = 1;
  double turn = 0;  ///< radians, counter-clockwise
  Vec2d shift;

  /// Where a point of the given curve is placed.
  Vec2d point(const Vec2d& p) const { return shift + vector(p); }
  /// The same of a difference of points.
  Vec2d vector(const Vec2d& v) const { return scale * (direction() * v); }
  /// The point of the given curve that is placed at `p`.
  Vec2d point_back(const Vec2d& p) const { return (1 / scale) * (conj(direction()) * (p - shift)); }

 private:
  Vec2d direction() const { return {std::cos(turn), std::sin(turn)}; }
};

/// The note of a result whose file requests a certificate in vain.
inline constexpr const char* kNothingToCertify =
    "There is no certificate: the search has not found a design that meets every constraint, or "
    "was "
    "ended early.";

/// What a branch and bound over all designs of `domain` proved. Errors are what the search
/// minimises: the weighted sum of squares in the target's unit.
struct Certificate {
  double lower_bound = 0;   ///< no design of the domain that satisfies the constraints errs by less
  double upper_bound = 0;   ///< the error of the best design found
  double gap_relative = 0;  ///< (upper − lower)/upper, 0 where upper is rounding
  bool complete = false;    ///< the gap requested was reached, not ended by time
  std::uint64_t boxes = 0;  ///< parts of the domain examined
  std::string domain;       ///< which designs were looked at, in words
};

/// Error at the targets, in the target's unit (length for paths and motions, radians for
/// functions). Of a motion by least squares it holds the angle too, by its weight. `sum_of_squares`
/// is unweighted.
struct TargetError {
  double sum_of_squares = 0;
  double rms = 0;
  double max = 0;
};

/// Which side of a number is allowed.
enum class BoundSide { least, most };

/// One constraint of the file, checked on the finished design by the analysis kernel.
struct ConstraintCheck {
  std::string name;  ///< the key of the file, with its unit; "bounds.crank" for bounds
  std::variant<double, std::string> value;
  std::variant<double, std::string, Range> bound;
  bool satisfied = true;
  /// By how much it is missed, relative to the linkage, where the bound itself has no size.
  std::optional<double> missing{};
  /// Whether a number as bound is the least or the most, where the name does not say it.
  std::optional<BoundSide> relation{};
};

/// See analysis/linkage/defects.hpp.
enum class Defect { circuit, branch, order };

/// What the analysis kernel says of a design.
struct Metrics {
  std::optional<MobilityClass>
      mobility;  ///< of a four-bar; `quantities` hold another type's "class"
  bool change_point = false;
  /// Extremes of the transmission angle over the motion used: the full turn of a crank that turns
  /// fully, else the range between the target positions (of a function its whole domain). In [0,
  /// π].
  double transmission_min = 0;
  double transmission_max = 0;
  double transmission_acute_min = 0;  ///< min(μ, π − μ) over the same motion, at its least
  std::optional<double> time_ratio;   ///< K; empty where the crank does not turn fully
  std::vector<Defect> defects;
  CycleValues cycle;  ///< over the full turn, where the file limits them or makes them least
  std::optional<double> input_start, output_start;      ///< function generation: α₀, φ₀
  std::optional<double> precision_residual, condition;  ///< exact synthesis: of what it solved
  std::vector<Quantity> quantities;  ///< what the kind of problem or the type of mechanism adds
};

/// A mechanism that was found, what it is like, and what it misses.
struct Design {
  NamedMechanism mechanism;
  std::vector<double> crank_angles;  ///< at the target points, from the x axis, in [0, 2π)
  TargetError error;
  Metrics metrics;
  std::vector<ConstraintCheck> constraints;
  /// `exact:<method>`, `algebraic`, `search` or `given`, then " + <solver>".
  std::string origin;
  std::optional<int> cognate_of;  ///< index of the better design that traces the same curve
  /// Where the target came, if it may be moved; `error` is in the target's own unit all the same.
  std::optional<CurvePlacement> placement;
  std::optional<int> mirror_of;  ///< index of the design of which this is the mirror image
  std::optional<int> twin_of{};  ///< index of the design that has the same links; see twins.hpp
  /// In what a mirror image or a twin differs: "assembly", "direction", "pivots", "coupler point".
  std::vector<std::string> differs{};
  /// Sentences on what meets the constraints and would hardly be built; see warnings.hpp.
  std::vector<std::string> warnings{};
  std::optional<ToleranceResult> tolerance{};  ///< where the file has tolerances
  std::optional<LayerResult> layers{};         ///< where the file has layers, see design_layers.hpp
};

/// The four-bar that `design` is. Only where its type is four_bar.
inline const FourBar& four_bar(const Design& design) {
  return *design.mechanism.four_bar();
}

/// A curve of the plane that a synthesis returns with its designs: "centre-point curve".
struct Locus {
  std::string name;
  std::vector<std::vector<Vec2d>> branches;
};

/// A column of a family; `name` carries the unit: "crank_pivot_deg".
struct FamilyColumn {
  std::string name;
  std::vector<double> values;  ///< NaN where there is none (null in files)
};

/// Designs that depend on one number, the first column; all columns have one length.
struct Family {
  std::string name;
  std::vector<FamilyColumn> columns;
};

/// How a run ended: with a design that meets every constraint, with none that does, with no design
/// at all, out of time, or stopped; or not begun, since the problem is `invalid` (no file that was
/// read is).
enum class Status { solved, infeasible, no_solution, time_limit, interrupted, invalid };

/// What was evaluated, and what was skipped because nothing requested it.
struct Work {
  double seconds = 0;
  int threads = 1;
  std::uint64_t candidates = 0;  ///< designs screened
  std::uint64_t positions = 0;
  std::uint64_t velocities = 0;
  std::uint64_t accelerations = 0;
  std::uint64_t reactions = 0;  ///< positions whose joint forces were computed
  std::uint64_t gradients = 0;
  std::uint64_t solver_iterations = 0;
  std::vector<std::string> skipped;
};

/// The answer to a design problem.
struct Result {
  Status status = Status::no_solution;
  std::vector<Design> designs;  ///< best first; feasible ones before others
  std::vector<Locus> loci;
  std::vector<Family> families;
  std::vector<Quantity> quantities;  ///< counts of a synthesis as a whole: "complex_solutions"
  std::optional<Certificate> certificate;  ///< where the file requests one and a design is feasible
  Work work;
  std::vector<std::string> notes;  ///< sentences for the user: degeneracies, why nothing was found
  std::vector<std::string> warnings{};  ///< those of the designs, with their numbers
};

/// A part of a run, as its progress names it.
enum class Phase {
  search,
  exact,  ///< the solutions of a polynomial system
  front,
  raster,
  robustness,
  infeasibility,  ///< which constraints exclude one another
  certificate,
  positions,  ///< of an analysis
  tolerances,
  layers,
  simulation  ///< of a machine
};

/// How a run is steered from outside.
struct Run {
  std::uint64_t seed = 1;
  int threads = 0;                   ///< 0: as many as the machine has
  std::optional<double> time_limit;  ///< seconds
  const std::atomic<bool>* interrupted = nullptr;
  /// Designs that a search by optimisation begins with, in addition to its own starts; with
  /// solve.starts = 0, which no file can ask for, instead of them.
  std::vector<Design> known{};
  std::filesystem::path cache;  ///< folder for what is the same in every run; none if empty
  /// Called now and then from one thread with the share done (0…1) and the best objective so far.
  std::function<void(double share, double best)> progress;
  /// Called when a part of the run begins that ends at the share `to` of the run; NaN where the
  /// share that is done does not tell how long the rest takes.
  std::function<void(Phase phase, double to)> phase{};

  /// Tells `phase`, where it is set, that the part `begun` begins, which ends at the share `to`.
  void enter(Phase begun, double to = 1) const {
    if (phase) phase(begun, to);
  }
};

/// Of a part of which nobody knows beforehand how long it takes.
inline constexpr double kUnknownEnd = std::numeric_limits<double>::quiet_NaN();

/// `run` for a part of it whose progress goes from the share `from` to the share `to`.
inline Run part_of(const Run& run, double from, double to) {
  const auto share_of_run = [from, to](double share) { return from + (to - from) * share; };
  Run part = run;
  if (run.progress) {
    part.progress = [progress = run.progress, share_of_run](double share, double best) {
      progress(share_of_run(share), best);
    };
  }
  if (run.phase) {
    part.phase = [phase = run.phase, share_of_run](Phase begun, double end) {
      phase(begun, share_of_run(end));
    };
  }
  return part;
}

/// `run` for what no progress is shown of.
inline Run silent(Run run) {
  run.progress = nullptr;
  run.phase = nullptr;
  return run;
}

template <>
std::span<const Named<Phase>> names<Phase>();
template <>
std::span<const Named<Status>> names<Status>();
template <>
std::span<const Named<Defect>> names<Defect>();

/// The user's interrupt or the end of a run's time.
class Deadline : public synthesis::Deadline {
 public:
  /// That of `run`, whose time begins now.
  explicit Deadline(const Run& run)
      : synthesis::Deadline(run.time_limit.value_or(std::numeric_limits<double>::infinity()),
                            run.interrupted) {}
};

/// What solving a problem with such faults gives; `AnyResult` has a status and notes.
template <class AnyResult>
AnyResult refused(std::vector<std::string> faults) {
  AnyResult result;
  result.status = Status::invalid;
  result.notes = std::move(faults);
  return result;
}

}  // namespace cognate::problems
