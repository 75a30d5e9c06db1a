// One design over a crank table: cut into pieces for threads, and into packs by the kernel.
#include <algorithm>
#include <vector>

#include "analysis/batch/columns.hpp"
#include "analysis/batch/dispatch.hpp"
#include "analysis/numbers/parallel.hpp"

namespace cognate {
namespace batch {
namespace {

/// Rows of a piece for a thread: enough to pay for the design's constants and the thread's trouble.
constexpr std::size_t kPieceRows = 4096;

Design<double> prepare(const FourBar& linkage) {
  return Design<double>(Dimensions<double>{linkage.pivot_a, linkage.pivot_d, linkage.crank,
                                           linkage.coupler, linkage.rocker,
                                           sign(linkage.assembly)});
}

/// The runs of the table cut into pieces; the last of a run takes what is left.
std::vector<Run> pieces_of(std::span<const Run> runs) {
  std::vector<Run> pieces;
  for (const Run& run : runs) {
    std::size_t begin = run.begin;
    for (; run.end - begin >= 2 * kPieceRows; begin += kPieceRows) {
      pieces.push_back({begin, begin + kPieceRows, run.side});
    }
    pieces.push_back({begin, run.end, run.side});
  }
  return pieces;
}

template <class Real>
class OneDesign {
 public:
  OneDesign(const FourBar& linkage, const CrankTable<Real>& cranks,
            const ColumnPointers<Real>& wanted, const Kernels<Real>& kernels)
      : design_(prepare(linkage)),
        point_(linkage.coupler_point.value_or(Vec2d{})),
        cranks_(cranks),
        wanted_(wanted),
        kernels_(kernels),
        instance_(instance_for(wanted.wanted)) {}

  /// All of the table. A row's values do not depend on the pack that they are calculated in.
  void evaluate(int threads) const {
    const auto runs = cranks_.runs();
    if (!is_direct()) {
      for (const Run& run : runs) evaluate_aside(run);
    } else if (thread_count(threads) == 1 || cranks_.size() < 2 * kPieceRows) {
      evaluate_directly(runs);
    } else {
      const std::vector<Run> pieces = pieces_of(runs);
      parallel_for(static_cast<int>(pieces.size()), threads, [&](int i, int) {
        evaluate_directly(std::span(pieces).subspan(static_cast<std::size_t>(i), 1));
      });
    }
  }

 private:
  bool is_direct() const {
    const auto long_enough = [&](const Run& run) { return run.end - run.begin >= kernels_.lanes; };
    return cranks_.in_order() && std::ranges::all_of(cranks_.runs(), long_enough);
  }

  OneDesignTask<Real> task_of(std::span<const Run> runs) const {
    return {
        &design_, point_, runs.data(), runs.size(), cranks_.sin().data(), cranks_.versine().data(),
        {}};
  }

  void evaluate_directly(std::span<const Run> runs) const {
    OneDesignTask<Real> task = task_of(runs);
    std::ranges::copy(wanted_.columns, task.columns);
    kernels_.one_design(instance_, task);
  }

  /// By way of a buffer, for fewer rows than the kernel has lanes, or rows out of order.
  void evaluate_aside(const Run& run) const {
    const std::size_t count = run.end - run.begin, height = std::max(count, kernels_.lanes);
    const Run whole{0, height, run.side};
    std::vector<Real> buffer(kColumns * height);
    OneDesignTask<Real> task = task_of({&whole, 1});
    task.sin += run.begin;
    task.versine += run.begin;
    for (std::size_t i = 0; i < kColumns; ++i) {
      task.columns[i] = wanted_.columns[i] ? buffer.data() + i * height : nullptr;
    }
    kernels_.one_design(instance_, task);
    const auto order = cranks_.order().subspan(run.begin, count);
    for (std::size_t i = 0; i < kColumns; ++i) {
      if (!wanted_.columns[i]) continue;
      for (std::size_t k = 0; k < count; ++k) wanted_.columns[i][order[k]] = task.columns[i][k];
    }
  }

  Design<double> design_;
  Vec2d point_;
  const CrankTable<Real>& cranks_;
  const ColumnPointers<Real>& wanted_;
  const Kernels<Real>& kernels_;
  std::size_t instance_;
};

}  // namespace
}  // namespace batch

template <class Real>
BatchStatus evaluate_batch(const FourBar& linkage, const CrankTable<Real>& cranks,
                           const FourBarColumns<Real>& columns, const BatchOptions& options) {
  const auto wanted = batch::column_pointers(columns, cranks.size(), 1);
  if (!wanted) return BatchStatus::sizes_differ;
  if (wanted->wanted == 0) return BatchStatus::nothing_wanted;
  if (wanted->wanted != batch::transmission && !linkage.coupler_point) {
    return BatchStatus::no_coupler_point;
  }
  const auto kernels = batch::find_kernels<Real>(options.instruction_set);
  if (!kernels) return BatchStatus::missing_instruction_set;
  batch::OneDesign<Real>(linkage, cranks, *wanted, *kernels).evaluate(options.threads);
  return BatchStatus::done;
}

template BatchStatus evaluate_batch(const FourBar&, const CrankTable<double>&,
                                    const FourBarColumns<double>&, const BatchOptions&);
template BatchStatus evaluate_batch(const FourBar&, const CrankTable<float>&,
                                    const FourBarColumns<float>&, const BatchOptions&);

}  // namespace cognate
