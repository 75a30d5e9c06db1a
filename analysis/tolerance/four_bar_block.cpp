#include "analysis/tolerance/four_bar_block.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "analysis/batch/four_bar_batch.hpp"

namespace cognate::tolerance {
namespace {

/// Columns of a FourBarTask but for the points: pivots, lengths, assembly.
constexpr std::size_t kOwnColumns = 8;

struct Frame {
  Vec2d pivot_a, pivot_d;
};

/// Of a crank and a dyad on its pin and on a point of the frame; else empty.
std::optional<Frame> frame_of(const Mechanism<double>& mechanism) {
  if (mechanism.dyads.size() != 1) return std::nullopt;
  const auto* crank = std::get_if<Crank<double>>(&mechanism.drive);
  const auto* dyad = std::get_if<Rrr<double>>(&mechanism.dyads.front());
  if (!crank || !dyad || dyad->first.body != 1 || dyad->second.body != 0) return std::nullopt;
  if (dyad->first.at.y != 0 || !(dyad->first.at.x > 0)) return std::nullopt;
  return Frame{crank->pivot, dyad->second.at};
}

/// The direction of the frame, if no dimension turns it, or the crank's pin in the crank.
std::optional<double> fixed_direction(const AffineMechanism& mechanism) {
  constexpr double kParallel = 1e-15;
  const auto nominal = frame_of(mechanism.nominal().mechanism);
  if (!nominal) return std::nullopt;
  const Vec2d along = nominal->pivot_d - nominal->pivot_a;
  if (!(norm(along) > 0)) return std::nullopt;
  for (std::size_t i = 0; i < mechanism.dimension_count(); ++i) {
    std::vector<double> changes(mechanism.dimension_count());
    changes[i] = norm(along);
    const auto frame = frame_of(mechanism.at<double>(changes).mechanism);
    if (!frame) return std::nullopt;
    const Vec2d changed = frame->pivot_d - frame->pivot_a;
    if (std::abs(cross(along, changed)) > kParallel * squared_norm(along)) return std::nullopt;
  }
  return std::atan2(along.y, along.x);
}

bool is_possible(const BlockOutput& output, const AffineMechanism& mechanism, bool last) {
  switch (output.of) {
    case BlockOutput::Of::angle:
      return output.body == 3;
    case BlockOutput::Of::point:
      return mechanism.nominal().points[static_cast<std::size_t>(output.point)].body == 2;
    case BlockOutput::Of::transmission:
      return last;
    default:
      return false;
  }
}

}  // namespace

std::optional<FourBarBlock> FourBarBlock::of(const AffineMechanism& mechanism,
                                             std::span<const Station> stations,
                                             std::span<const BlockOutput> outputs,
                                             InstructionSet set) {
  const auto direction = fixed_direction(mechanism);
  if (!direction || stations.empty() || outputs.empty()) return std::nullopt;
  for (const BlockOutput& output : outputs) {
    if (!is_possible(output, mechanism, &output == &outputs.back())) return std::nullopt;
  }
  const double side = stations.front().sides.front();
  std::vector<double> angles;
  for (const Station& station : stations) {
    if (station.sides.front() != side) return std::nullopt;
    angles.push_back(std::atan2(station.drive.direction.y, station.drive.direction.x));
  }
  return FourBarBlock(CrankTable<double>(angles, *direction), outputs, side, set);
}

FourBarBlock::FourBarBlock(CrankTable<double> cranks, std::span<const BlockOutput> outputs,
                           double side, InstructionSet set)
    : cranks_(std::move(cranks)),
      outputs_(outputs.begin(), outputs.end()),
      points_(outputs.size()),
      side_(side),
      set_(set) {
  if (outputs_.back().of == BlockOutput::Of::transmission) --points_;
  dimensions_.assign((kOwnColumns + 2 * points_) * kBlockSamples, side);
}

void FourBarBlock::evaluate(const SampleKernels& kernels, const BlockTask& task,
                            std::span<double> values) {
  const auto columns = [&](std::size_t first, std::size_t count) {
    return std::span(dimensions_).subspan(first * kBlockSamples, count * kBlockSamples);
  };
  const FourBarTask linkages{.mechanism = &task,
                             .own = columns(0, kOwnColumns).data(),
                             .u = columns(kOwnColumns, points_).data(),
                             .v = columns(kOwnColumns + points_, points_).data(),
                             .outputs = outputs_.data(),
                             .points = points_};
  kernels.four_bars(linkages);
  const std::size_t column = cranks_.size() * kBlockSamples;
  const auto outputs = [&](std::size_t first, std::size_t count) {
    return values.subspan(first * column, count * column);
  };
  const bool transmits = points_ < outputs_.size();
  const FourBarColumns<double> results{
      .x = outputs(0, points_),
      .y = outputs(outputs_.size(), points_),
      .transmission_sin = outputs(outputs_.size() + points_, transmits ? 1 : 0),
      .transmission_cos = outputs(points_, transmits ? 1 : 0)};
  const FourBarArrays<double> arrays{columns(0, 1),
                                     columns(1, 1),
                                     columns(2, 1),
                                     columns(3, 1),
                                     columns(4, 1),
                                     columns(5, 1),
                                     columns(6, 1),
                                     columns(7, 1),
                                     columns(kOwnColumns, points_),
                                     columns(kOwnColumns + points_, points_)};
  const BatchStatus status = evaluate_batch(arrays, cranks_, results, {.instruction_set = set_});
  if (status != BatchStatus::done) std::ranges::fill(values, NAN);
  kernels.directions(linkages, cranks_.size());
  if (side_ < 0) {
    for (double& sine : results.transmission_sin) sine = -sine;
  }
}

}  // namespace cognate::tolerance
