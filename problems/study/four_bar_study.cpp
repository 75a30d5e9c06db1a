#include "problems/study/four_bar_study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "analysis/batch/four_bar_batch.hpp"
#include "analysis/coupler_curve/curve_measures.hpp"
#include "analysis/linkage/mobility.hpp"
#include "problems/evaluation/curve_metrics.hpp"
#include "problems/study/base.hpp"
#include "problems/study/design_points.hpp"
#include "problems/study/filter.hpp"
#include "problems/study/four_bar_designs.hpp"
#include "problems/study/four_bar_plan.hpp"
#include "problems/study/four_bar_quantities.hpp"
#include "problems/study/four_bar_screen.hpp"

namespace cognate::problems {
namespace {

/// Samples curves over a whole turn of the crank, as many as lie in the fast memory of a core.
class FourBarCurves {
 public:
  /// Curves of `steps` samples each, `most` at once: a multiple of 8, which every set of
  /// instructions has lanes for.
  FourBarCurves(std::size_t steps, std::size_t most);

  std::size_t most() const { return most_; }

  /// Curves of no more than `most` linkages with coupler points.
  void sample(std::span<const FourBar> linkages);

  /// Of linkage i: whether its samples settle the length; and the sums over them.
  bool is_settled(std::size_t i) const { return sums_.is_settled(i); }
  double length(std::size_t i) const { return sums_.length[i]; }
  double area(std::size_t i) const { return sums_.area[i]; }

  /// The samples of linkage i, until this is called for another.
  CurveSamples curve(std::size_t i);

 private:
  std::size_t most_;
  CrankTable<double> cranks_;
  std::array<std::vector<double>, 10> designs_;
  CurveRoom samples_;  ///< sample j of linkage i at j·most + i
  CurveRoom one_;
  CurveSums sums_;
};

FourBarCurves::FourBarCurves(std::size_t steps, std::size_t most)
    : most_(most), cranks_(CrankTable<double>::full_turn(steps)) {
  for (auto& column : designs_) column.resize(most);
  samples_.resize(steps * most);
  one_.resize(steps);
}

void FourBarCurves::sample(std::span<const FourBar> linkages) {
  // The last is repeated, so that every lane holds a linkage.
  for (std::size_t i = 0; i < most_; ++i) {
    const FourBar& linkage = linkages[std::min(i, linkages.size() - 1)];
    const std::array<double, 10> numbers{
        linkage.pivot_a.x,       linkage.pivot_a.y,      linkage.pivot_d.x,
        linkage.pivot_d.y,       linkage.crank,          linkage.coupler,
        linkage.rocker,          sign(linkage.assembly), linkage.coupler_point->x,
        linkage.coupler_point->y};
    for (std::size_t k = 0; k < numbers.size(); ++k) designs_[k][i] = numbers[k];
  }
  const auto& d = designs_;
  const FourBarArrays<double> arrays{d[0], d[1], d[2], d[3], d[4], d[5], d[6], d[7], d[8], d[9]};
  const BatchStatus status = evaluate_batch(
      arrays, cranks_,
      FourBarColumns<double>{
          .x = samples_.x, .y = samples_.y, .velocity_x = samples_.dx, .velocity_y = samples_.dy});
  static_cast<void>(status);  // sizes agree, and the widest instruction set is there
  sums_.add_up(samples_.samples(), most_);
}

CurveSamples FourBarCurves::curve(std::size_t i) {
  for (std::size_t j = 0; j < one_.x.size(); ++j) {
    const std::size_t at = j * most_ + i;
    one_.x[j] = samples_.x[at];
    one_.y[j] = samples_.y[at];
    one_.dx[j] = samples_.dx[at];
    one_.dy[j] = samples_.dy[at];
  }
  return one_.samples();
}

/// Evaluates blocks, for one thread.
class FourBarBlocks {
 public:
  FourBarBlocks(const Study& study, std::uint64_t seed, const std::atomic<bool>* interrupted,
                FourBarPlan plan, StudyBase text)
      : study_(&study),
        interrupted_(interrupted),
        plan_(std::move(plan)),
        text_(std::move(text)),
        points_(study, seed),
        screen_(plan_.filters) {}

  std::optional<StudyBlock> operator()(std::int64_t first, std::int64_t count) {
    begin(first, count);
    for (std::size_t i = 0; i < designs_.size(); ++i) {
      if (stays_[i] == 0) continue;
      if (is_interrupted()) return std::nullopt;
      consider(i);
    }
    if (!evaluate_curves()) return std::nullopt;
    return gather(first, count);
  }

 private:
  struct Candidate {
    std::size_t design = 0;
    RunStatus status = RunStatus::solved;
    bool dropped = false;
  };

  bool is_interrupted() const { return interrupted_ && interrupted_->load(); }

  void begin(std::int64_t first, std::int64_t count) {
    values_.resize(static_cast<std::size_t>(count) * plan_.dimensions.size());
    points_.fill(first, values_);
    designs_.fill(plan_.linkage(), plan_.dimensions, values_);
    stays_.assign(designs_.size(), 1);
    if (!study_->keep_all) screen_(designs_, values_, plan_.dimensions.size(), stays_);
    candidates_.clear();
    cells_.clear();
    turning_.clear();
    others_.clear();
  }

  std::span<const double> values(std::size_t i) const {
    const std::size_t variables = plan_.dimensions.size();
    return std::span(values_).subspan(i * variables, variables);
  }

  std::span<Cell> cells(std::size_t candidate) {
    return std::span(cells_).subspan(candidate * plan_.columns.size(), plan_.columns.size());
  }

  /// All of a design but its curve.
  void consider(std::size_t i) {
    const FourBar linkage = designs_.design(plan_.linkage(), i);
    const Lengths<double> links = lengths(linkage);
    const std::size_t candidate = candidates_.size();
    candidates_.push_back({i});
    cells_.resize(cells_.size() + plan_.columns.size());
    if (!is_common(linkage)) return analyse_design(candidate);
    closed_.begin(links);
    if (ClosedForms::is_special(links)) return consider_special(candidate);
    if (plan_.wants_swing && closed_.assembles() && !closed_.turns()) {
      return analyse_design(candidate);  // how far the output swings depends on the crank's course
    }
    const auto cell = [&](const FourBarQuantity& quantity) { return closed_cell(quantity, i); };
    if (!evaluate_stages(candidate, FourBarStage::varied, FourBarStage::varied, cell)) return;
    if (!closed_.turns() && !has_closed_row(plan_.base.drive, linkage)) {
      return without_motion(candidate);
    }
    if (!evaluate_stages(candidate, FourBarStage::links, FourBarStage::closed_forms, cell)) return;
    const bool has_curve = plan_.wants(FourBarStage::size, FourBarStage::features);
    if (has_curve) (closed_.turns() ? turning_ : others_).push_back(candidate);
  }

  /// Near a change point the class still depends on the lengths alone, and may decide.
  void consider_special(std::size_t candidate) {
    const std::size_t i = candidates_[candidate].design;
    const auto fails = [&](const FourBarFilter& filter) {
      const FourBarQuantity& quantity = filter.quantity;
      return ClosedForms::is_of_lengths(quantity.quantity) &&
             !problems::passes(*filter.limits, closed_cell(quantity, i));
    };
    if (study_->keep_all || std::ranges::none_of(plan_.filters, fails)) {
      return analyse_design(candidate);
    }
    candidates_[candidate].status = RunStatus::filtered;
    candidates_[candidate].dropped = true;
  }

  Cell closed_cell(const FourBarQuantity& quantity, std::size_t i) {
    if (quantity.quantity == FourBarQuantityId::varied) return values(i)[quantity.variable];
    if (quantity.metric) return curve_cell(quantity, i);
    return closed_(quantity.quantity);
  }

  /// Of the links of a curve, which are there before it is drawn.
  Cell curve_cell(const FourBarQuantity& quantity, std::size_t i) {
    if (!closed_.assembles()) return {};
    curve_.begin(designs_.design(plan_.linkage(), i), {});
    return number(curve_(*quantity.metric));
  }

  static Cell number(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Cell(*value) : Cell();
  }

  /// Whether the filters of some stages let a design pass; drops it, or marks it, if not.
  template <class Value>
  bool passes(std::size_t candidate, FourBarStage from, FourBarStage to, Value value) {
    for (const FourBarFilter& filter : plan_.filters) {
      const FourBarStage stage = filter.quantity.stage;
      if (stage < from || stage > to || problems::passes(*filter.limits, value(filter.quantity)))
        continue;
      candidates_[candidate].status = RunStatus::filtered;
      if (study_->keep_all) {
        fill(candidate, from, stage, value);
      } else {
        candidates_[candidate].dropped = true;
      }
      return false;
    }
    return true;
  }

  template <class Value>
  void fill(std::size_t candidate, FourBarStage from, FourBarStage to, Value value) {
    const std::span<Cell> row = cells(candidate);
    for (std::size_t k = 0; k < row.size(); ++k) {
      const FourBarQuantity& quantity = plan_.columns[k];
      if (quantity.stage >= from && quantity.stage <= to) row[k] = value(quantity);
    }
  }

  /// A linkage that no row of the drive can assemble has none of the quantities.
  void without_motion(std::size_t candidate) {
    candidates_[candidate].status = RunStatus::no_solution;
    passes(candidate, FourBarStage::links, FourBarStage::features,
           [](const FourBarQuantity&) { return Cell(); });
  }

  /// A design as any other base would be evaluated.
  void analyse_design(std::size_t candidate) {
    const std::size_t i = candidates_[candidate].design;
    auto task = text_.with(values(i));
    std::vector<Quantity> quantities;
    if (task) {
      AnalysisProblem& problem = std::get<AnalysisProblem>(*task);
      problem.output = {.position = false,
                        .velocity = false,
                        .acceleration = false,
                        .transmission = false,
                        .curve = problem.mechanism.four_bar()->coupler_point.has_value()};
      AnalysisResult result = analyse(problem, Run{.threads = 1});
      const bool solved = result.status == Status::solved;
      if (solved) quantities = std::move(result.quantities);
      candidates_[candidate].status = solved ? RunStatus::solved : RunStatus::no_solution;
    } else {
      candidates_[candidate].status = RunStatus::invalid;
    }
    const auto cell = [&](const FourBarQuantity& quantity) -> Cell {
      if (quantity.quantity == FourBarQuantityId::varied) return values(i)[quantity.variable];
      const auto found = std::ranges::find(quantities, quantity.name, &Quantity::name);
      return found == quantities.end() ? Cell() : cell_of(found->value);
    };
    evaluate_stages(candidate, FourBarStage::varied, FourBarStage::features, cell);
  }

  static Cell cell_of(const std::variant<double, std::string, bool>& value) {
    if (const auto* const truth = std::get_if<bool>(&value)) {
      return std::string(*truth ? "true" : "false");
    }
    if (const auto* const text = std::get_if<std::string>(&value)) return *text;
    return number(std::get<double>(value));
  }

  /// False if interrupted.
  bool evaluate_curves() {
    for (FourBarCurves& curves : curves_) {
      rough_.clear();
      for (std::size_t begin = 0; begin < turning_.size(); begin += curves.most()) {
        if (is_interrupted()) return false;
        const std::size_t end = std::min(begin + curves.most(), turning_.size());
        evaluate_turning(curves, std::span(turning_).subspan(begin, end - begin));
      }
      std::swap(turning_, rough_);
    }
    for (const std::size_t candidate : others_) {
      if (is_interrupted()) return false;
      const FourBar linkage = linkage_of(candidate);
      curve_.begin(linkage, circuit_at(linkage, plan_.base.drive.start));
      evaluate_curve(candidate, FourBarStage::size, FourBarStage::features);
    }
    return true;
  }

  /// Those whose samples do not settle their length are left for more samples, the last apart.
  void evaluate_turning(FourBarCurves& curves, std::span<const std::size_t> piece) {
    linkages_.clear();
    for (const std::size_t candidate : piece) linkages_.push_back(linkage_of(candidate));
    const bool samples = plan_.wants(FourBarStage::sums, FourBarStage::descriptors);
    const bool gathered = plan_.wants(FourBarStage::widths, FourBarStage::descriptors);
    if (samples) curves.sample(linkages_);
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const bool settled = samples && curves.is_settled(k);
      if (samples && !settled && &curves != &curves_.back()) {
        rough_.push_back(piece[k]);
        continue;
      }
      curve_.begin(linkages_[k], {linkages_[k].assembly, 1});
      if (settled) curve_.know_sums(curves.length(k), curves.area(k));
      if (!evaluate_curve(piece[k], FourBarStage::size, FourBarStage::sums)) continue;
      if (settled && gathered) curve_.use(curves.curve(k));
      evaluate_curve(piece[k], FourBarStage::widths, FourBarStage::features);
    }
  }

  FourBar linkage_of(std::size_t candidate) const {
    return designs_.design(plan_.linkage(), candidates_[candidate].design);
  }

  /// The values of some stages into the design's row; false, and none, if their filters stop it.
  template <class Value>
  bool evaluate_stages(std::size_t candidate, FourBarStage from, FourBarStage to, Value value) {
    if (!passes(candidate, from, to, value)) return false;
    fill(candidate, from, to, value);
    return true;
  }

  bool evaluate_curve(std::size_t candidate, FourBarStage from, FourBarStage to) {
    return evaluate_stages(candidate, from, to, [&](const FourBarQuantity& quantity) {
      return number(curve_(*quantity.metric));
    });
  }

  StudyBlock gather(std::int64_t first, std::int64_t count) {
    StudyBlock block{.first = first, .count = count};
    block.filtered = count - static_cast<std::int64_t>(candidates_.size());
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
      const Candidate& candidate = candidates_[k];
      if (candidate.status == RunStatus::filtered) ++block.filtered;
      if (candidate.dropped) continue;
      block.ids.push_back(first + static_cast<std::int64_t>(candidate.design));
      block.statuses.push_back(candidate.status);
      std::ranges::move(cells(k), std::back_inserter(block.cells));
    }
    return block;
  }

  const Study* study_;
  const std::atomic<bool>* interrupted_;
  FourBarPlan plan_;
  StudyBase text_;
  DesignPoints points_;
  FourBarScreen screen_;
  std::vector<double> values_, stays_;
  FourBarDesigns designs_;
  std::vector<Candidate> candidates_;
  std::vector<Cell> cells_;
  std::vector<std::size_t> turning_, others_;  ///< candidates whose curves are requested
  std::vector<std::size_t> rough_;             ///< of these the ones that want more samples
  std::vector<FourBar> linkages_;
  ClosedForms closed_;
  /// As large as a core's nearest memory has room for, and then as few as there are lanes.
  std::array<FourBarCurves, 3> curves_{FourBarCurves(kCurveSteps[0], 64),
                                       FourBarCurves(kCurveSteps[1], 16),
                                       FourBarCurves(kCurveSteps[2], 8)};
  CurveValues curve_;
};

}  // namespace

std::optional<BlockEvaluator> four_bar_evaluator(const Study& study, std::uint64_t seed,
                                                 const std::atomic<bool>* interrupted) {
  auto plan = four_bar_plan(study);
  if (!plan) return std::nullopt;
  // A std::function wants to be copied, which the base's text cannot be.
  auto blocks =
      std::make_shared<FourBarBlocks>(study, seed, interrupted, *std::move(plan), StudyBase(study));
  return [blocks](std::int64_t begin, std::int64_t count) { return (*blocks)(begin, count); };
}

}  // namespace cognate::problems
