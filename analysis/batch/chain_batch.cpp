#include "analysis/batch/chain_batch.hpp"

#include <algorithm>

#include "analysis/batch/chain_kernel.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/parallel.hpp"

namespace cognate {
namespace batch {
namespace {

/// Rows of a piece for a thread.
constexpr std::size_t kChainPieceRows = 4096;

ChainKernels chain_kernels_of(InstructionSet set) {
  switch (set) {
#ifdef COGNATE_X86_KERNELS
    case InstructionSet::sse2:
      return sse2::chain_kernels();
    case InstructionSet::avx2:
      return avx2::chain_kernels();
    case InstructionSet::avx512:
      return avx512::chain_kernels();
#endif
    default:
      return scalar::chain_kernels();
  }
}

/// Columns as the kernels take them, and what is needed for them.
class Outputs {
 public:
  explicit Outputs(std::size_t rows) : rows_(rows) {}

  void add(const PointColumns& columns) {
    ChainOutput output{ChainOutput::Of::point, columns.point.body, columns.point.at, {}, {}};
    for (std::size_t k = 0; k < 4; ++k) {
      add_pair(columns.x[k], columns.y[k], static_cast<int>(k), output);
    }
    outputs_.push_back(output);
  }

  void add(const BodyColumns& columns) {
    ChainOutput output{ChainOutput::Of::body, columns.body, {}, {}, {}};
    add_pair(columns.cos, columns.sin, 0, output);
    for (std::size_t k = 1; k < 4; ++k) {
      output.first[k] = pointer(columns.turn[k - 1], static_cast<int>(k));
    }
    outputs_.push_back(output);
  }

  void add(const DyadColumns& columns) {
    ChainOutput output{ChainOutput::Of::dyad, columns.dyad, {}, {}, {}};
    add_pair(columns.sine, columns.cosine, 0, output);
    outputs_.push_back(output);
  }

  BatchStatus status() const {
    if (sizes_differ_) return BatchStatus::sizes_differ;
    return order_ < 0 ? BatchStatus::nothing_wanted : BatchStatus::done;
  }
  int order() const { return order_; }
  const std::vector<ChainOutput>& outputs() const { return outputs_; }

 private:
  void add_pair(std::span<double> first, std::span<double> second, int order, ChainOutput& output) {
    if (first.size() != second.size()) sizes_differ_ = true;
    output.first[order] = pointer(first, order);
    output.second[order] = pointer(second, order);
  }

  double* pointer(std::span<double> column, int order) {
    if (column.empty()) return nullptr;
    if (column.size() != rows_) sizes_differ_ = true;
    order_ = std::max(order_, order);
    return column.data();
  }

  std::size_t rows_;
  std::vector<ChainOutput> outputs_;
  int order_ = -1;
  bool sizes_differ_ = false;
};

/// Whether the columns speak of bodies and dyads that are there.
bool is_known(const Mechanism<double>& mechanism, const ChainColumns& columns) {
  const auto is_body = [&](int body) { return 0 <= body && body < body_count(mechanism); };
  const auto dyads = static_cast<int>(mechanism.dyads.size());
  return std::ranges::all_of(columns.points, is_body,
                             [](const PointColumns& c) { return c.point.body; }) &&
         std::ranges::all_of(columns.bodies, is_body, &BodyColumns::body) &&
         std::ranges::all_of(columns.dyads,
                             [&](const DyadColumns& c) { return 0 <= c.dyad && c.dyad < dyads; });
}

}  // namespace
}  // namespace batch

DriveTable::DriveTable(const Mechanism<double>& mechanism, std::span<const double> coordinates) {
  cos_.reserve(coordinates.size());
  sin_.reserve(coordinates.size());
  displacement_.reserve(coordinates.size());
  for (const double coordinate : coordinates) {
    const DrivePosition<double> at = drive_position(mechanism, coordinate);
    cos_.push_back(at.direction.x);
    sin_.push_back(at.direction.y);
    displacement_.push_back(at.displacement);
  }
}

BatchStatus evaluate_batch(const Mechanism<double>& mechanism, std::span<const double> sides,
                           const DriveTable& drives, const ChainColumns& columns,
                           const BatchOptions& options) {
  batch::Outputs outputs(drives.size());
  for (const PointColumns& c : columns.points) outputs.add(c);
  for (const BodyColumns& c : columns.bodies) outputs.add(c);
  for (const DyadColumns& c : columns.dyads) outputs.add(c);
  if (sides.size() != mechanism.dyads.size() || !batch::is_known(mechanism, columns)) {
    return BatchStatus::sizes_differ;
  }
  if (outputs.status() != BatchStatus::done) return outputs.status();

  const auto sets = instruction_sets();
  const InstructionSet set = options.instruction_set.value_or(sets.back());
  if (std::ranges::find(sets, set) == sets.end()) return BatchStatus::missing_instruction_set;
  batch::ChainKernels kernels = batch::chain_kernels_of(set);
  if (drives.size() < kernels.lanes) kernels = batch::scalar::chain_kernels();

  const std::size_t pieces = std::max<std::size_t>(1, drives.size() / batch::kChainPieceRows);
  const auto evaluate_piece = [&](int i, int /*thread*/) {
    const auto piece = static_cast<std::size_t>(i);
    const std::size_t begin = piece * batch::kChainPieceRows;
    const std::size_t end = piece + 1 == pieces ? drives.size() : begin + batch::kChainPieceRows;
    kernels.by_order[outputs.order()]({&mechanism.drive, mechanism.dyads.data(), sides.data(),
                                       mechanism.dyads.size(), drives.cos().data(),
                                       drives.sin().data(), drives.displacement().data(), begin,
                                       end, outputs.outputs().data(), outputs.outputs().size()});
  };
  parallel_for(static_cast<int>(pieces), options.threads, evaluate_piece);
  return BatchStatus::done;
}

}  // namespace cognate
