#include "synthesis/exact/nine_point/tracker.hpp"

#include <algorithm>

#include "analysis/numbers/parallel.hpp"

namespace cognate::synthesis::nine_point {
namespace {

struct Kernels {
  void (*track)(const TrackTask& task);
  void (*inspect)(const InspectTask& task);
};

Kernels kernels_of(InstructionSet set) {
  switch (set) {
#ifdef COGNATE_X86_KERNELS
    case InstructionSet::sse2:
      return {sse2::track, sse2::inspect};
    case InstructionSet::avx2:
      return {avx2::track, avx2::inspect};
    case InstructionSet::avx512:
      return {avx512::track, avx512::inspect};
#endif
    default:
      return {scalar::track, scalar::inspect};
  }
}

/// Those requested if this machine has them, else the widest.
Kernels choose_kernels(const TrackingOptions& means) {
  const auto here = instruction_sets();
  const bool has = means.set && std::find(here.begin(), here.end(), *means.set) != here.end();
  return kernels_of(has ? *means.set : here.back());
}

/// What the threads share.
struct Queue {
  int count;
  std::atomic<int> next{0};
  const TrackingOptions& means;

  static int take(void* context) {
    Queue& queue = *static_cast<Queue*>(context);
    if (stop(context)) return -1;
    const int path = queue.next++;
    if (path >= queue.count) return -1;
    if (queue.means.done) queue.means.done(path);
    return path;
  }
  static bool stop(void* context) {
    const Queue& queue = *static_cast<Queue*>(context);
    return queue.means.stop && queue.means.stop->stopped();
  }
};

}  // namespace

bool StopToken::stopped() {
  if (!ask_ || stopped_) return stopped_;
  const std::unique_lock lock(asking_, std::try_to_lock);
  if (lock && !stopped_ && ask_()) stopped_ = true;
  return stopped_;
}

TrackedPaths track(const PathBundle& bundle, const TrackingOptions& means) {
  const int count = static_cast<int>(bundle.line_of.size());
  TrackedPaths paths;
  paths.ends.resize(bundle.starts.size());
  paths.how.assign(count, PathEnd::unfinished);
  paths.remaining.assign(count, 1);
  paths.steps.assign(count, 0);
  const std::vector<double> ones(bundle.from.empty() ? count : 0, 1);
  const double* from = bundle.from.empty() ? ones.data() : bundle.from.data();
  Queue queue{count, 0, means};
  const TrackTask task{bundle.points,         bundle.starts.data(), from,
                       bundle.line_of.data(), bundle.lines.data(),  means.settings,
                       Queue::take,           Queue::stop,          &queue,
                       paths.ends.data(),     paths.how.data(),     paths.remaining.data(),
                       paths.steps.data()};
  const auto kernel = means.extended ? double_double::track : choose_kernels(means).track;
  // One call of the kernel for each thread: it takes paths until there are none.
  const int threads = std::min(thread_count(means.threads), std::max(1, count));
  parallel_for(threads, threads, [&](int, int) { kernel(task); });
  return paths;
}

Inspection inspect(std::span<const Pair> roots, int points, const ParameterLine& data,
                   bool extended, const TrackingOptions& means) {
  constexpr int kBlock = 32;  // roots at a time, a multiple of all numbers of lanes
  const int count = static_cast<int>(roots.size()) / unknowns(points);
  Inspection found;
  found.values.resize(static_cast<std::size_t>(count) * 2 * kPositions);
  found.changes.resize(roots.size());
  found.conditions.resize(count);
  const auto kernel = choose_kernels(means).inspect;
  parallel_for((count + kBlock - 1) / kBlock, means.threads, [&](int block, int) {
    InspectTask task{};
    task.points = points;
    task.data = &data;
    task.roots = roots.data();
    task.first = block * kBlock;
    task.last = std::min(count, task.first + kBlock);
    task.values = found.values.data();
    if (extended) {
      double_double::inspect(task);
      task.given = task.values;
      task.values = nullptr;
    }
    task.changes = found.changes.data();
    task.conditions = found.conditions.data();
    kernel(task);
  });
  return found;
}

}  // namespace cognate::synthesis::nine_point
