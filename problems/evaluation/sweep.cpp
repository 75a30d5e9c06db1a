#include "problems/evaluation/sweep.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/parallel.hpp"
#include "problems/evaluation/drive_rows.hpp"
#include "problems/evaluation/instant_geometry.hpp"
#include "problems/evaluation/load_breaks.hpp"
#include "problems/evaluation/whole_motion.hpp"

namespace cognate::problems {
namespace {

/// Adds whole turns to `degrees`, each in (−180, 180], so that each differs from the one before it
/// by half a turn at most. What is not a number is passed over: after a gap the angle goes on from
/// where it was before.
void make_continuous(std::span<double> degrees) {
  constexpr double kTurn = 360;
  double before = 0;
  bool first = true;
  for (double& angle : degrees) {
    if (!std::isfinite(angle)) continue;
    if (!first) angle += kTurn * std::round((before - angle) / kTurn);
    before = angle;
    first = false;
  }
}

constexpr int kRowsOfBlock = 256;

/// The rows [first, last) of a block, by one thread.
template <int Order>
class BlockFiller {
 public:
  BlockFiller(const AnalysisProblem& problem, const AssemblyRanges& assembly_ranges,
              std::span<const Stroke> strokes)
      : kinematics_(problem, assembly_ranges), forces_(problem, strokes) {
    if (!problem.output.instant_geometry.empty()) instants_.emplace(problem, assembly_ranges);
  }

  void fill(ColumnPlan& plan, std::span<RowState> rows, int first, int last) {
    for (int row = first; row < last; ++row) {
      RowState& state = rows[static_cast<std::size_t>(row)];
      state = kinematics_.fill(plan, row);
      if constexpr (Order >= 2) {
        if (state.open_dyad != kNone || state.dead_point) continue;
        state.power = forces_.fill(plan, row, kinematics_.bodies());
        if (instants_) instants_->fill(plan, row);
      }
    }
  }

 private:
  RowFiller<Order> kinematics_;
  ForceFiller forces_;
  std::optional<InstantGeometryFiller> instants_;
};

template <int Order>
void fill_all(const AnalysisProblem& problem, const Run& run, const Deadline& deadline,
              Sweep& all) {
  const int rows = row_count(problem.drive);
  const int blocks = (rows + kRowsOfBlock - 1) / kRowsOfBlock;
  const auto strokes = load_strokes(problem, deadline);
  std::vector<char> done(static_cast<std::size_t>(blocks), 0);
  std::atomic<int> finished{0};
  parallel_for(blocks, run.threads, [&](int block, int thread) {
    if (deadline.reached()) return;
    const int first = block * kRowsOfBlock;
    BlockFiller<Order>(problem, all.assembly_ranges, strokes)
        .fill(all.plan, all.rows, first, std::min(first + kRowsOfBlock, rows));
    done[static_cast<std::size_t>(block)] = 1;
    ++finished;
    if (thread == 0 && run.progress) {
      run.progress(double(finished) / blocks, std::numeric_limits<double>::infinity());
    }
  });
  const auto whole = std::ranges::find(done, 0) - done.begin();
  all.rows.resize(std::min(static_cast<std::size_t>(whole) * kRowsOfBlock, all.rows.size()));
}

/// What is neither a number nor finite is NaN; zero has no sign; angles go on from row to row.
void finish(Sweep& all) {
  for (auto& column : all.plan.columns) {
    column.values.resize(all.rows.size());
    for (double& value : column.values) value = std::isfinite(value) ? value + 0.0 : kNaN;
  }
  for (const auto& body : all.plan.bodies) {
    if (body.angle.position == kNone) continue;
    make_continuous(all.plan.columns[static_cast<std::size_t>(body.angle.position)].values);
  }
}

}  // namespace

Sweep sweep(const AnalysisProblem& problem, const Run& run, const Deadline& deadline) {
  Sweep all{
      .plan = plan_columns(problem),
      .assembly_ranges = follow_until(problem, problem.drive.start, problem.drive.end, deadline)};
  const auto rows = static_cast<std::size_t>(row_count(problem.drive));
  all.rows.resize(rows);
  for (auto& column : all.plan.columns) column.values.assign(rows, kNaN);
  switch (needed_order(problem.output)) {
    case 0:
      fill_all<0>(problem, run, deadline, all);
      break;
    case 1:
      fill_all<1>(problem, run, deadline, all);
      break;
    default:
      fill_all<2>(problem, run, deadline, all);
  }
  finish(all);
  return all;
}

}  // namespace cognate::problems
