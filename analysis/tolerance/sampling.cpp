#include "analysis/tolerance/sampling.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "analysis/numbers/parallel.hpp"
#include "analysis/tolerance/four_bar_block.hpp"
#include "analysis/tolerance/sample_kernel.hpp"

namespace cognate {
namespace tolerance {
namespace {

constexpr std::size_t kBlocksOfPiece = 64;
constexpr std::size_t kPieceSamples = kBlocksOfPiece * kBlockSamples;

SampleKernels kernels_of(InstructionSet set) {
  switch (set) {
#ifdef COGNATE_X86_KERNELS
    case InstructionSet::sse2:
      return sse2::sample_kernels();
    case InstructionSet::avx2:
      return avx2::sample_kernels();
    case InstructionSet::avx512:
      return avx512::sample_kernels();
#endif
    default:
      return scalar::sample_kernels();
  }
}

/// Everything that all blocks share.
struct Question {
  const AffineMechanism& mechanism;
  std::span<const JudgedResponse> judged;
  std::span<const Station> stations;
  const SamplingOptions& options;
  InstructionSet set;
  SampleKernels kernels;
  std::vector<double> cos{}, sin{}, displacement{}, sides{};

  void take_stations() {
    for (const Station& station : stations) {
      cos.push_back(station.drive.direction.x);
      sin.push_back(station.drive.direction.y);
      displacement.push_back(station.drive.displacement);
      sides.insert(sides.end(), station.sides.begin(), station.sides.end());
    }
  }
};

/// Sums over the samples of a piece, to be added up in the order of pieces.
struct PieceSums {
  std::vector<double> sum, square;  ///< response·stations + station
  std::size_t drawn = 0, assembled = 0;
};

BlockOutput block_output(const Response& response) {
  const int index = static_cast<int>(response.index);
  switch (response.type) {
    case ResponseType::displacement: {
      const SlidingPair& slide = response.slide;
      return {.of = BlockOutput::Of::displacement,
              .body = slide.slider,
              .guide = slide.through.body,
              .through = slide.through.at,
              .along = slide.direction};
    }
    case ResponseType::point:
      return {.of = BlockOutput::Of::point, .point = index};
    case ResponseType::along:
      return {.of = BlockOutput::Of::along, .point = index, .along = response.direction};
    case ResponseType::direction:
      return {
          .of = BlockOutput::Of::direction, .point = index, .to = static_cast<int>(response.to)};
    case ResponseType::transmission:
      return {.of = BlockOutput::Of::transmission, .body = index};
    case ResponseType::angle:
    case ResponseType::closure:  // of which no samples are asked
      break;
  }
  return {.of = BlockOutput::Of::angle, .body = index};
}

/// The room in which a thread computes blocks.
class BlockRoom {
 public:
  explicit BlockRoom(const Question& question)
      : question_(question),
        changes_(question.mechanism.dimension_count() * kBlockSamples),
        values_(2 * question.judged.size() * question.stations.size() * kBlockSamples),
        weight_(kBlockSamples),
        extremes_(question.judged.size() * kBlockSamples) {
    const std::size_t column = question.stations.size() * kBlockSamples;
    for (std::size_t r = 0; r < question.judged.size(); ++r) {
      BlockOutput output = block_output(question.judged[r].response);
      output.x = values_.data() + r * column;
      output.y = output.x + question.judged.size() * column;
      outputs_.push_back(output);
    }
    four_bar_ = FourBarBlock::of(question.mechanism, question.stations, outputs_, question.set);
  }

  /// Samples first… of the block: adds them to `sums`, and their extremes to `extremes`, the
  /// columns of which are `stride` apart; not numbers for those that are not assembled.
  void compute(std::size_t first, std::size_t count, PieceSums& sums, double* extremes,
               std::size_t stride) {
    question_.options.draw(first, kBlockSamples, changes_);
    evaluate();
    weigh(count, sums);
    std::ranges::fill(extremes_, 0.0);
    const std::size_t stations = question_.stations.size();
    for (std::size_t r = 0; r < outputs_.size(); ++r) {
      const JudgedResponse& judged = question_.judged[r];
      double* own = extremes_.data() + r * kBlockSamples;
      question_.kernels.errors({.x = outputs_[r].x,
                                .y = outputs_[r].y,
                                .stations = stations,
                                .samples = count,
                                .angular = is_angular(judged.response.type),
                                .point = judged.response.type == ResponseType::point,
                                .reference = judged.reference.data(),
                                .normal = judged.normal.empty() ? nullptr : judged.normal.data(),
                                .offset = judged.offset.data(),
                                .weight = weight_.data(),
                                .extreme = own,
                                .sum = sums.sum.data() + r * stations,
                                .square = sums.square.data() + r * stations});
      for (std::size_t i = 0; i < count; ++i) {
        extremes[r * stride + i] =
            weight_[i] > 0 ? own[i] : std::numeric_limits<double>::quiet_NaN();
      }
    }
  }

 private:
  void evaluate() {
    const auto& nominal = question_.mechanism.nominal();
    const auto terms = question_.mechanism.terms();
    const BlockTask task{.drive = &nominal.mechanism.drive,
                         .dyads = nominal.mechanism.dyads.data(),
                         .dyad_count = nominal.mechanism.dyads.size(),
                         .points = nominal.points.data(),
                         .point_count = nominal.points.size(),
                         .begin = terms.begin,
                         .dimension = terms.dimension,
                         .factor = terms.factor,
                         .changes = changes_.data(),
                         .cos = question_.cos.data(),
                         .sin = question_.sin.data(),
                         .displacement = question_.displacement.data(),
                         .sides = question_.sides.data(),
                         .stations = question_.stations.size(),
                         .outputs = outputs_.data(),
                         .output_count = outputs_.size()};
    if (four_bar_) {
      four_bar_->evaluate(question_.kernels, task, values_);
    } else {
      question_.kernels.evaluate(task);
    }
  }

  /// A sample counts where every value is a number.
  void weigh(std::size_t count, PieceSums& sums) {
    std::vector<double>& total = weight_;
    std::ranges::fill(total, 0.0);
    for (std::size_t k = 0; k < values_.size(); k += kBlockSamples) {
      for (std::size_t i = 0; i < kBlockSamples; ++i) total[i] += values_[k + i];
    }
    for (std::size_t i = 0; i < kBlockSamples; ++i) {
      weight_[i] = i < count && std::isfinite(total[i]) ? 1 : 0;
    }
    sums.drawn += count;
    sums.assembled += static_cast<std::size_t>(std::ranges::count(weight_, 1.0));
  }

  const Question& question_;
  std::vector<double> changes_, values_, weight_, extremes_;
  std::vector<BlockOutput> outputs_;
  std::optional<FourBarBlock> four_bar_;
};

StationStatistics statistics_of(double sum, double square, double count) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  if (!(count > 0)) return {kUnknown, kUnknown};
  const double mean = sum / count;
  if (!(count > 1)) return {mean, kUnknown};
  return {mean, std::sqrt(std::max((square - sum * mean) / (count - 1), 0.0))};
}

SampleStatistics reduced(const Question& question, const std::vector<PieceSums>& pieces,
                         const std::vector<double>& extremes, std::size_t stride) {
  SampleStatistics all;
  const std::size_t stations = question.stations.size();
  std::vector<double> sum(question.judged.size() * stations), square(sum.size());
  for (const PieceSums& piece : pieces) {
    all.samples += piece.drawn;
    all.assembled += piece.assembled;
    for (std::size_t i = 0; i < piece.sum.size(); ++i) {
      sum[i] += piece.sum[i];
      square[i] += piece.square[i];
    }
  }
  for (std::size_t r = 0; r < question.judged.size(); ++r) {
    ResponseStatistics& response = all.responses.emplace_back();
    for (std::size_t s = 0; s < stations; ++s) {
      response.stations.push_back(statistics_of(sum[r * stations + s], square[r * stations + s],
                                                static_cast<double>(all.assembled)));
    }
    response.extremes.reserve(all.assembled);
    for (std::size_t i = 0; i < stride; ++i) {
      if (std::isfinite(extremes[r * stride + i])) {
        response.extremes.push_back(extremes[r * stride + i]);
      }
    }
  }
  return all;
}

}  // namespace
}  // namespace tolerance

SampleStatistics sample(const AffineMechanism& mechanism, std::span<const JudgedResponse> judged,
                        std::span<const Station> stations, const SamplingOptions& options) {
  using namespace tolerance;
  const InstructionSet set = options.instruction_set.value_or(instruction_sets().back());
  Question question{mechanism, judged, stations, options, set, kernels_of(set)};
  question.take_stations();
  const std::size_t count = options.samples;
  const std::size_t piece_count = (count + kPieceSamples - 1) / kPieceSamples;
  std::vector<double> extremes(judged.size() * count, std::numeric_limits<double>::quiet_NaN());
  std::vector<PieceSums> pieces(piece_count);
  std::atomic<bool> stopped = false;
  const auto threads = static_cast<std::size_t>(thread_count(options.threads));
  std::vector<std::optional<BlockRoom>> rooms(threads);
  parallel_for(static_cast<int>(piece_count), options.threads, [&](int index, int thread) {
    if (stopped || (options.stop && options.stop())) {
      stopped = true;
      return;
    }
    auto& room = rooms[static_cast<std::size_t>(thread)];
    if (!room) room.emplace(question);
    PieceSums& sums = pieces[static_cast<std::size_t>(index)];
    sums.sum.assign(judged.size() * stations.size(), 0);
    sums.square.assign(sums.sum.size(), 0);
    const std::size_t begin = static_cast<std::size_t>(index) * kPieceSamples;
    const std::size_t end = std::min(count, begin + kPieceSamples);
    for (std::size_t first = begin; first < end; first += kBlockSamples) {
      room->compute(first, std::min(kBlockSamples, end - first), sums, extremes.data() + first,
                    count);
    }
  });
  return reduced(question, pieces, extremes, count);
}

}  // namespace cognate
