// Many designs over one crank table: cut into pieces for threads, and into packs by the kernel.
#include <algorithm>
#include <vector>

#include "analysis/batch/columns.hpp"
#include "analysis/batch/dispatch.hpp"
#include "analysis/numbers/parallel.hpp"

namespace cognate {
namespace batch {
namespace {

/// Designs of a piece, a multiple of every kernel's lanes. It is the same for any number of
/// threads, so that a design is always calculated in the same way.
constexpr std::size_t kPieceDesigns = 256;

/// The arrays that have one value for each design.
template <class Real>
std::array<std::span<const Real>, 8> dimensions_of(const FourBarArrays<Real>& linkages) {
  return {linkages.pivot_a_x, linkages.pivot_a_y, linkages.pivot_d_x, linkages.pivot_d_y,
          linkages.crank,     linkages.coupler,   linkages.rocker,    linkages.assembly};
}

template <class Real>
bool sizes_agree(const FourBarArrays<Real>& linkages) {
  const std::size_t count = linkages.crank.size();
  const auto all = dimensions_of(linkages);
  return std::all_of(all.begin(), all.end(), [&](auto one) { return one.size() == count; }) &&
         linkages.point_u.size() == linkages.point_v.size() &&
         (count == 0 ? linkages.point_u.empty() : linkages.point_u.size() % count == 0);
}

template <class Real>
ManyDesignsTask<Real> task_of(const FourBarArrays<Real>& linkages, const CrankTable<Real>& cranks,
                              const std::array<Real*, kColumns>& columns) {
  const std::size_t count = linkages.crank.size();
  ManyDesignsTask<Real> task{
      .pivot_a_x = linkages.pivot_a_x.data(),
      .pivot_a_y = linkages.pivot_a_y.data(),
      .pivot_d_x = linkages.pivot_d_x.data(),
      .pivot_d_y = linkages.pivot_d_y.data(),
      .crank = linkages.crank.data(),
      .coupler = linkages.coupler.data(),
      .rocker = linkages.rocker.data(),
      .assembly = linkages.assembly.data(),
      .point_u = linkages.point_u.data(),
      .point_v = linkages.point_v.data(),
      .designs = count,
      .points = linkages.point_u.size() / count,
      .first = 0,
      .last = count,
      .sin = cranks.sin().data(),
      .versine = cranks.versine().data(),
      .order = cranks.order().data(),
      .runs = cranks.runs().data(),
      .run_count = cranks.runs().size(),
      .rows = cranks.size(),
      .columns = {},
  };
  std::copy(columns.begin(), columns.end(), task.columns);
  return task;
}

/// `from`, blocks of `count` values, with blocks of `width` ≥ count values, the last one repeated.
template <class Real>
std::vector<Real> widen(std::span<const Real> from, std::size_t count, std::size_t width) {
  std::vector<Real> wide;
  for (std::size_t block = 0; block < from.size(); block += count) {
    for (std::size_t i = 0; i < width; ++i) wide.push_back(from[block + std::min(i, count - 1)]);
  }
  return wide;
}

/// Fewer designs than the kernel has lanes: the last is repeated, and its copies are dropped.
template <class Real>
void evaluate_few(const FourBarArrays<Real>& linkages, const CrankTable<Real>& cranks,
                  const ColumnPointers<Real>& wanted, const Kernels<Real>& kernels) {
  const std::size_t count = linkages.crank.size(), width = kernels.lanes;
  std::array<std::vector<Real>, 8> wide;
  const auto dimensions = dimensions_of(linkages);
  for (std::size_t i = 0; i < wide.size(); ++i) wide[i] = widen(dimensions[i], count, width);
  const std::vector<Real> point_u = widen(linkages.point_u, count, width);
  const std::vector<Real> point_v = widen(linkages.point_v, count, width);
  const std::size_t points = linkages.point_u.size() / count;

  std::array<std::vector<Real>, kColumns> results;
  std::array<Real*, kColumns> columns{};
  for (std::size_t i = 0; i < kColumns; ++i) {
    if (!wanted.columns[i]) continue;
    results[i].resize(cranks.size() * width * (of_points(i) ? points : 1));
    columns[i] = results[i].data();
  }
  const FourBarArrays<Real> widened{wide[0], wide[1], wide[2], wide[3], wide[4],
                                    wide[5], wide[6], wide[7], point_u, point_v};
  kernels.many_designs(instance_for(wanted.wanted), task_of(widened, cranks, columns));
  for (std::size_t i = 0; i < kColumns; ++i) {
    for (std::size_t k = 0; k * width < results[i].size(); ++k) {
      std::copy_n(results[i].begin() + static_cast<std::ptrdiff_t>(k * width), count,
                  wanted.columns[i] + k * count);
    }
  }
}

template <class Real>
void evaluate_many(const FourBarArrays<Real>& linkages, const CrankTable<Real>& cranks,
                   const ColumnPointers<Real>& wanted, const Kernels<Real>& kernels, int threads) {
  const ManyDesignsTask<Real> all = task_of(linkages, cranks, wanted.columns);
  const std::size_t pieces = std::max<std::size_t>(1, all.designs / kPieceDesigns);
  const std::size_t instance = instance_for(wanted.wanted);
  parallel_for(static_cast<int>(pieces), threads, [&](int index, int) {
    const auto piece = static_cast<std::size_t>(index);
    ManyDesignsTask<Real> task = all;
    task.first = piece * kPieceDesigns;
    if (piece + 1 < pieces) task.last = task.first + kPieceDesigns;
    kernels.many_designs(instance, task);
  });
}

}  // namespace
}  // namespace batch

template <class Real>
BatchStatus evaluate_batch(const FourBarArrays<Real>& linkages, const CrankTable<Real>& cranks,
                           const FourBarColumns<Real>& columns, const BatchOptions& options) {
  if (!batch::sizes_agree(linkages)) return BatchStatus::sizes_differ;
  const std::size_t count = linkages.crank.size();
  const std::size_t points = count == 0 ? 0 : linkages.point_u.size() / count;
  const auto wanted =
      batch::column_pointers(columns, count * cranks.size(), std::max<std::size_t>(1, points));
  if (!wanted) return BatchStatus::sizes_differ;
  if (wanted->wanted == 0) return BatchStatus::nothing_wanted;
  if (wanted->wanted != batch::transmission && points == 0) return BatchStatus::no_coupler_point;
  const auto kernels = batch::find_kernels<Real>(options.instruction_set);
  if (!kernels) return BatchStatus::missing_instruction_set;
  if (count < kernels->lanes) {
    batch::evaluate_few(linkages, cranks, *wanted, *kernels);
  } else {
    batch::evaluate_many(linkages, cranks, *wanted, *kernels, options.threads);
  }
  return BatchStatus::done;
}

template BatchStatus evaluate_batch(const FourBarArrays<double>&, const CrankTable<double>&,
                                    const FourBarColumns<double>&, const BatchOptions&);
template BatchStatus evaluate_batch(const FourBarArrays<float>&, const CrankTable<float>&,
                                    const FourBarColumns<float>&, const BatchOptions&);

}  // namespace cognate
