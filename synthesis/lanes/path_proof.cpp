#include "synthesis/lanes/path_proof.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "synthesis/lanes/path_proof_kernel.hpp"

namespace cognate::synthesis {
namespace {

using ProofKernel = void (*)(const PathProofTask& task);

ProofKernel proof_kernel_of(InstructionSet set) {
  switch (set) {
#ifdef COGNATE_X86_KERNELS
    case InstructionSet::sse2:
      return sse2::prove_paths;
    case InstructionSet::avx2:
      return avx2::prove_paths;
    case InstructionSet::avx512:
      return avx512::prove_paths;
#endif
    default:
      return scalar::prove_paths;
  }
}

constexpr int kProofLanes = 8;  // of the widest kernel

struct alignas(kProofAlignment) ProofLine {
  double values[kProofAlignment / sizeof(double)];
};

/// The memory of one thread's kernel.
struct ProofWorkspace {
  std::array<double, std::size_t{proof_numbers} * kProofBoxes> box;
  std::array<int, kProofBoxes> reached, side;
  std::vector<ProofLine> lines;
};

ProofWorkspace& proof_workspace(std::size_t samples) {
  thread_local ProofWorkspace workspace;
  const std::size_t lines = samples * kProofWorkPerSample * sizeof(double) / sizeof(ProofLine);
  if (workspace.lines.size() < lines) workspace.lines.resize(lines);
  return workspace;
}

double half_width(const Interval& side) {
  return side.low == side.high ? 0 : side.radius();
}

void write_box(const ProportionBox& box, double* at) {
  const auto put = [&](std::ptrdiff_t which, double value) { at[which * kProofBoxes] = value; };
  put(proof_k, box.side[0].middle());
  put(proof_half_k, half_width(box.side[0]));
  put(proof_side, box.proportions == Proportions::frame_shortest ? -1 : 1);
  put(proof_assembly, box.assembly);
  for (int i = 0; i < 3; ++i) {
    const Interval& side = box.side[1 + i];
    const double middle = 0.5 * side.middle(), half = half_width(side);
    int which = proof_angles + 5 * i;
    for (const double value :
         {half, std::sin(middle), std::cos(middle), std::sin(0.5 * half), std::cos(0.5 * half)}) {
      put(which++, value);
    }
  }
}

constexpr double kNearestPoint = 1e-6;
constexpr double kNarrowestSide = 1e-13;  // no side is divided further

/// `side`, or where that is as narrow as it may be the widest.
int divisible(const ProportionBox& box, int side) {
  const auto width = [&](int i) { return box.side[i].high - box.side[i].low; };
  if (side >= 0 && width(side) > kNarrowestSide) return side;
  int widest = -1;
  for (int i = 0; i < kBoxSides; ++i) {
    if (width(i) > kNarrowestSide && (widest < 0 || width(i) > width(widest))) widest = i;
  }
  return widest;
}

}  // namespace

bool has_path_proof(const TimedPath& path, const ProportionBox& box) {
  return box.proportions != Proportions::any && !path.direction_fixed &&
         box.side[3].high > box.side[3].low;
}

PathProver::PathProver(TimedPath path, const ProportionLimits& limits,
                       std::optional<InstructionSet> set)
    : path_(std::move(path)), limits_(limits) {
  const auto sets = instruction_sets();
  const bool has = set && std::ranges::find(sets, *set) != sets.end();
  set_ = has ? *set : sets.back();
  std::complex<double> centre;
  double weight = 0;
  for (std::size_t j = 0; j < path_.points.size(); ++j) {
    centre += path_.weights[j] * path_.points[j];
    weight += path_.weights[j];
  }
  centre = path_.pivot_fixed ? 0.0 : centre / weight;
  for (std::size_t j = 0; j < path_.points.size(); ++j) {
    const double angle = path_.crank_angles[j];
    half_sine_.push_back(std::sin(0.5 * angle));
    half_cosine_.push_back(std::cos(0.5 * angle));
    sine_.push_back(std::sin(angle));
    cosine_.push_back(std::cos(angle));
    mean_sine_ += sine_.back() / double(path_.points.size());
    mean_cosine_ += cosine_.back() / double(path_.points.size());
    x_.push_back((path_.points[j] - centre).real());
    y_.push_back((path_.points[j] - centre).imag());
  }
}

/// Whether the limits allow a linkage of the box.
bool PathProver::is_possible(const ProportionBox& box) const {
  const ProportionRanges ranges = ranges_of(box);
  double low = 0, high = 0;
  return may_satisfy(ranges, limits_, true) && crank_range(ranges, path_.lengths, low, high) &&
         may_transmit(ranges, limits_, ranges.inner, ranges.outer);
}

void PathProver::judge_block(std::span<const ProportionBox> boxes, double target,
                             double first_target, std::span<StageVerdict> verdicts) const {
  ProofWorkspace& own = proof_workspace(x_.size());
  std::array<std::size_t, kProofBoxes> place;
  int count = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    verdicts[i] = {2, -1};
    if (!is_possible(boxes[i])) continue;
    write_box(boxes[i], own.box.data() + count);
    place[count++] = i;
  }
  if (count == 0) return;
  const int lanes = (count + kProofLanes - 1) / kProofLanes * kProofLanes;
  for (int i = count; i < lanes; ++i) write_box(boxes[place[count - 1]], own.box.data() + i);
  PathProofTask task{};
  task.samples = static_cast<int>(x_.size());
  task.half_sine = half_sine_.data();
  task.half_cosine = half_cosine_.data();
  task.sine = sine_.data();
  task.cosine = cosine_.data();
  task.x = x_.data();
  task.y = y_.data();
  task.weight = path_.weights.data();
  task.mean_sine = mean_sine_;
  task.mean_cosine = mean_cosine_;
  task.pivot_fixed = path_.pivot_fixed;
  // A limit of zero has no multiplier; a wider one holds as well.
  task.farthest_point = std::max(path_.farthest_point, kNearestPoint);
  task.target = target;
  task.first_target = first_target;
  task.boxes = lanes;
  task.box = own.box.data();
  task.reached = own.reached.data();
  task.side = own.side.data();
  task.workspace = own.lines.front().values;
  proof_kernel_of(set_)(task);
  for (int i = 0; i < count; ++i) {
    verdicts[place[i]] = {own.reached[i], divisible(boxes[place[i]], own.side[i])};
  }
}

void PathProver::judge(std::span<const ProportionBox> boxes, double target, double first_target,
                       std::span<StageVerdict> verdicts) const {
  for (std::size_t first = 0; first < boxes.size(); first += kProofBoxes) {
    const std::size_t count = std::min<std::size_t>(kProofBoxes, boxes.size() - first);
    judge_block(boxes.subspan(first, count), target, first_target, verdicts.subspan(first, count));
  }
}

}  // namespace cognate::synthesis
