#include "problems/cam/tolerance_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

#include "analysis/cam/changed_follower.hpp"
#include "analysis/cam/motion_programme.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "analysis/numbers/parallel.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/cam/toleranced_length.hpp"
#include "problems/linkage/design_tolerances.hpp"
#include "problems/tolerance/allocate.hpp"
#include "problems/tolerance/dimensions.hpp"
#include "problems/tolerance/draws.hpp"
#include "problems/tolerance/sampled.hpp"
#include "synthesis/tolerance/allocation.hpp"

namespace cognate::problems {
namespace {

constexpr std::size_t kPositions = 360;
constexpr std::size_t kMostCams = 10;
constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

using Dimensions = cam::CamDimensions<double>;
constexpr std::array<double Dimensions::*, kCamDimensions> kMembers = {
    &Dimensions::base_radius,     &Dimensions::offset, &Dimensions::roller_radius,
    &Dimensions::centre_distance, &Dimensions::arm,    &Dimensions::face_offset};

/// Of the cam.
double angle_at(std::size_t position) {
  return kTurn * double(position) / double(kPositions);
}

/// A cam whose dimensions may be off, and where its follower then stands.
class ChangedCam {
 public:
  ChangedCam(const CamProblem& problem, const cam::Cam& cam) : problem_(problem), cam_(cam) {
    for (std::size_t k = 0; k < kPositions; ++k) followers_.emplace_back(cam, angle_at(k));
  }

  /// Takes the dimensions that have a tolerance; what is wrong with it.
  std::optional<std::string> take() {
    for (std::size_t k = 0; k < kMembers.size(); ++k) {
      const double nominal = cam_.system.follower.dimensions.*kMembers[k];
      auto one = toleranced_length(problem_, static_cast<CamDimension>(k), nominal);
      if (!one) return std::move(one.error().reason);
      if (!*one) continue;
      dimensions_.push_back(**one);
      members_.push_back(k);
    }
    return std::nullopt;
  }

  const std::vector<TolerancedDimension>& dimensions() const { return dimensions_; }

  double place(std::span<const double> changes, std::size_t position) const {
    Dimensions change{};
    for (std::size_t i = 0; i < members_.size(); ++i) change.*kMembers[members_[i]] = changes[i];
    return followers_[position].misplacement(change).value_or(kMissing);
  }

  std::vector<double> rates(std::size_t position) const {
    const auto all = cam::misplacement_rates(cam_, angle_at(position));
    std::vector<double> own;
    for (const std::size_t member : members_) own.push_back(all[member]);
    return own;
  }

 private:
  const CamProblem& problem_;
  const cam::Cam& cam_;
  std::vector<TolerancedDimension> dimensions_;
  std::vector<std::size_t> members_;
  std::vector<cam::ChangedFollower> followers_;  ///< at each position
};

/// The greatest of `sense`·place over the box: each dimension at one of its ends, or between them
/// where the golden section finds more.
double greatest(const ChangedCam& cam, std::size_t position, double sense,
                std::vector<double>& changes, std::size_t dimension) {
  constexpr int kSteps = 40;
  const auto& dimensions = cam.dimensions();
  if (dimension == dimensions.size()) return sense * cam.place(changes, position);
  const auto at = [&](double change) {
    changes[dimension] = change;
    return greatest(cam, position, sense, changes, dimension + 1);
  };
  const double low = -dimensions[dimension].deviation.minus;
  const double high = dimensions[dimension].deviation.plus;
  const double from = at(low), to = at(high);
  if (std::isnan(from) || std::isnan(to)) return kMissing;
  const double most = std::max(from, to);
  // Between the ends only where the place turns back: then both rise from their ends.
  const double step = (high - low) / 64;
  if (!(at(low + step) > from && at(high - step) > to)) return most;
  const auto best = golden_section([&](double change) { return -at(change); }, low, high, kSteps);
  return std::max(most, -best.least());
}

PositionFigures figures_at(const ChangedCam& cam, const std::vector<double>& rates,
                           std::size_t position) {
  PositionFigures at;
  double high = 0, low = 0, squares = 0;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const auto& dimension = cam.dimensions()[i];
    const auto& [plus, minus] = dimension.deviation;
    high += std::max(rates[i] * plus, -rates[i] * minus);
    low += std::min(rates[i] * plus, -rates[i] * minus);
    squares += rates[i] * rates[i] * dimension.half_width() * dimension.half_width();
  }
  at.linear = std::max(high, -low);
  at.rss = std::sqrt(squares);
  std::vector<double> changes(rates.size());
  at.high = greatest(cam, position, 1, changes, 0);
  at.low = -greatest(cam, position, -1, changes, 0);
  return at;
}

std::size_t worst_of(const ToleranceFigures& figures,
                     const std::function<double(const PositionFigures&)>& of) {
  const auto worst = std::ranges::max_element(figures.positions, {}, of);
  return static_cast<std::size_t>(worst - figures.positions.begin());
}

void contribute(const ChangedCam& cam, const std::vector<std::vector<double>>& rates,
                ToleranceFigures& figures) {
  double total = 0;
  for (std::size_t i = 0; i < cam.dimensions().size(); ++i) {
    Contribution one{.dimension = cam.dimensions()[i].name};
    for (std::size_t s = 0; s < rates.size(); ++s) {
      if (std::abs(rates[s][i]) > std::abs(one.largest)) {
        one.largest = rates[s][i];
        one.largest_at = s;
      }
    }
    one.sensitivity = rates[figures.worst][i];
    one.amount = std::abs(one.sensitivity) * cam.dimensions()[i].half_width();
    total += one.amount;
    figures.contributions.push_back(std::move(one));
  }
  for (Contribution& one : figures.contributions) one.share = total > 0 ? one.amount / total : 0;
  std::ranges::stable_sort(figures.contributions, std::greater{}, &Contribution::amount);
}

/// Places of samples, in pieces whose sums are added in their order.
struct CamSums {
  std::vector<double> sum = std::vector<double>(kPositions), square = sum;
  std::vector<double> extremes;
};

void sample(const ChangedCam& cam, const Tolerances& tolerances, const Run& run,
            const Deadline& deadline, ToleranceResult& result) {
  constexpr std::size_t kPiece = 1024;
  const auto count = static_cast<std::size_t>(tolerances.samples);
  const std::size_t pieces = (count + kPiece - 1) / kPiece;
  std::vector<CamSums> sums(pieces);
  std::vector<std::size_t> drawn(pieces);
  const std::size_t dimensions = cam.dimensions().size();
  parallel_for(static_cast<int>(pieces), run.threads, [&](int index, int thread) {
    if (deadline.reached()) return;
    if (thread == 0 && run.progress) run.progress(double(index) / double(pieces), kInfinity);
    const auto piece = static_cast<std::size_t>(index);
    CamSums& own = sums[piece];
    const std::size_t first = piece * kPiece, size = std::min(kPiece, count - first);
    std::vector<double> changes(dimensions * size), one(dimensions), places(kPositions);
    draw_changes(cam.dimensions(), tolerances.distribution, run.seed, first, size, changes);
    reject_lost_lengths(cam.dimensions(), size, changes);
    drawn[piece] = size;
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t d = 0; d < dimensions; ++d) one[d] = changes[d * size + i];
      double extreme = 0;
      for (std::size_t s = 0; s < kPositions; ++s) {
        places[s] = cam.place(one, s);
        extreme = std::isnan(places[s]) ? kMissing : std::max(std::abs(places[s]), extreme);
        if (std::isnan(extreme)) break;
      }
      if (std::isnan(extreme)) continue;
      own.extremes.push_back(extreme);
      for (std::size_t s = 0; s < kPositions; ++s) {
        own.sum[s] += places[s];
        own.square[s] += places[s] * places[s];
      }
    }
  });
  CamSums all;
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    result.samples += drawn[piece];
    std::ranges::copy(sums[piece].extremes, std::back_inserter(all.extremes));
    for (std::size_t s = 0; s < kPositions; ++s) {
      all.sum[s] += sums[piece].sum[s];
      all.square[s] += sums[piece].square[s];
    }
  }
  result.assembled = all.extremes.size();
  const auto assembled = static_cast<double>(all.extremes.size());
  ToleranceFigures& figures = result.quantities.front();
  for (std::size_t s = 0; s < kPositions; ++s) {
    PositionFigures& at = figures.positions[s];
    const double excess = all.square[s] - all.sum[s] * all.sum[s] / assembled;
    at.mean = assembled > 0 ? all.sum[s] / assembled : kMissing;
    at.sigma = assembled > 1 ? std::sqrt(std::max(0.0, excess) / (assembled - 1)) : kMissing;
  }
  note_samples(result);
  set_yield(tolerances, figures.angle, all.extremes, result);
  set_extremes_of_samples(ResponseType::displacement, std::move(all.extremes), result.samples,
                          figures);
}

/// That a follower on a corner of its cam, or on both flanks of a hollow, is not found, which only
/// lessens what counts as assembled.
void note_unassembled(const cam::MotionProgramme& programme, ToleranceResult& result) {
  if (result.assembled == result.samples) return;
  const auto jumps = cam::jumps(programme);
  const bool has_corners =
      std::ranges::any_of(jumps, [](const cam::Jump& jump) { return jump.order <= 1; });
  result.notes.emplace_back(
      has_corners
          ? "where the velocity jumps the cam has a corner; samples whose follower would rest on "
            "it "
            "count as not assembled, so that yield and quantiles are worse than those of the parts"
          : "a follower that is larger than a hollow of its cam rests on both flanks; samples "
            "where "
            "it does count as not assembled, so that yield and quantiles are worse than those of "
            "the parts");
}

/// The least by which the base radius may shrink before the profile is undercut; not positive where
/// it is as designed.
double undercut_reserve(const cam::Cam& cam) {
  constexpr int kScanned = 3600;
  const auto& follower = cam.system.follower;
  double least = kInfinity;
  for (int k = 0; k < kScanned; ++k) {
    const auto motion = cam.programme.at(kTurn * k / kScanned);
    if (is_flat(follower.type)) {
      least = std::min(least, face_state(follower, cam.system.start, motion).radius);
      continue;
    }
    const double curvature = pitch_curvature(roller_state(follower, cam.system.start, motion));
    if (curvature > 0) least = std::min(least, 1 / curvature - follower.dimensions.roller_radius);
  }
  return least;
}

void note_undercut(const ChangedCam& changed, const cam::Cam& cam, ToleranceResult& result) {
  const auto& dimensions = changed.dimensions();
  const auto base = std::ranges::find(dimensions, "base_radius", &TolerancedDimension::name);
  const double shrunk = base == dimensions.end() ? 0 : base->deviation.minus;
  const double reserve = undercut_reserve(cam);
  if (reserve > shrunk) return;
  result.notes.emplace_back(
      reserve > 0
          ? "the profile is undercut where the base radius is at its least: there the "
            "follower drops further than these figures say"
          : "the profile is undercut as designed, so that the follower misses a part of its "
            "motion: these figures are of the profile without that");
}

void allocate(const ChangedCam& cam, const Tolerances& tolerances,
              const std::vector<std::vector<double>>& rates, bool angle, ToleranceResult& result) {
  if (!tolerances.allocation) return;
  const Allocation& allocation = *tolerances.allocation;
  const int power = allocation.basis == AllocationBasis::rss ? 2 : 1;
  const double limit = allocation.limit * (angle ? kPi / 180 : 1);
  std::vector<double> costs;
  for (const TolerancedDimension& dimension : cam.dimensions()) {
    const auto named = std::ranges::find(allocation.costs, dimension.name, &CostFactor::dimension);
    costs.push_back(named == allocation.costs.end() ? 1 : named->factor);
  }
  std::vector<synthesis::ToleranceDemand> demands;
  for (const auto& row : rates) {
    synthesis::ToleranceDemand demand{{}, std::pow(limit, power)};
    for (const double rate : row) demand.factors.push_back(std::pow(std::abs(rate), power));
    demands.push_back(std::move(demand));
  }
  const auto worst = [&](const std::vector<double>& t) {
    const auto spent = [&](const synthesis::ToleranceDemand& demand) {
      double sum = 0;
      for (std::size_t i = 0; i < t.size(); ++i) sum += demand.factors[i] * std::pow(t[i], power);
      return sum;
    };
    return *std::ranges::max_element(demands, {}, spent);
  };
  AllocatedCosts to{cam.dimensions(), costs, std::vector<double>(costs.size(), 0.0)};
  for (const auto& row : rates) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      to.influence[i] = std::max(to.influence[i], std::abs(row[i]));
    }
  }
  problems::allocate(to, worst, power, result);
  if (result.allocation_cost) result.allocation_error = allocation.limit;
}

void to_degrees(ToleranceFigures& figures) {
  constexpr double k = 180 / kPi;
  for (PositionFigures& at : figures.positions) {
    for (double PositionFigures::*of :
         {&PositionFigures::linear, &PositionFigures::low, &PositionFigures::high,
          &PositionFigures::rss, &PositionFigures::mean, &PositionFigures::sigma}) {
      at.*of *= k;
    }
  }
  for (Contribution& one : figures.contributions) {
    one.sensitivity *= k;
    one.largest *= k;
    one.amount *= k;
  }
  for (Quantile& quantile : figures.quantiles) quantile.error *= k;
  for (double& edge : figures.histogram_edges) edge *= k;
  figures.mean_extreme *= k;
}

ToleranceResult tolerances_of(const CamProblem& problem, const CamDesign& design, const Run& run,
                              const Deadline& deadline) {
  const Tolerances& tolerances = *problem.tolerances;
  const bool angle = cam::is_oscillating(problem.follower);
  ToleranceResult result;
  ChangedCam cam(problem, design.cam);
  if (auto fault = cam.take()) {
    result.refused = *std::move(fault);
    return result;
  }
  for (const auto& [name, nominal, deviation, is_length] : cam.dimensions()) {
    result.dimensions.push_back({name, nominal, deviation.plus, deviation.minus});
  }
  ToleranceFigures figures{.name = "follower", .angle = angle, .judged = true};
  std::vector<std::vector<double>> rates;
  for (std::size_t k = 0; k < kPositions; ++k) {
    result.drive.push_back(360.0 * double(k) / double(kPositions));
    rates.push_back(cam.rates(k));
    figures.positions.push_back(figures_at(cam, rates.back(), k));
  }
  figures.worst = worst_of(figures, [](const PositionFigures& at) { return at.linear; });
  figures.worst_exact = worst_of(figures, [](const PositionFigures& at) {
    const double size = std::max(at.high, -at.low);
    return std::isfinite(size) ? size : -1;
  });
  figures.exact = figures.exact_everywhere = std::ranges::all_of(
      figures.positions,
      [](const PositionFigures& at) { return std::isfinite(at.low) && std::isfinite(at.high); });
  contribute(cam, rates, figures);
  note_undercut(cam, design.cam, result);
  result.quantities.push_back(std::move(figures));
  allocate(cam, tolerances, rates, angle, result);
  if (tolerances.samples > 0) {
    sample(cam, tolerances, run, deadline, result);
    note_unassembled(design.cam.programme, result);
  }
  if (angle) to_degrees(result.quantities.front());
  return result;
}

}  // namespace

void add_tolerances(const CamProblem& problem, const Run& run, const Deadline& deadline,
                    CamResult& result) {
  if (!problem.tolerances) return;
  run.enter(Phase::tolerances, 1);
  const std::size_t count = std::min(result.designs.size(), kMostCams);
  for (std::size_t i = 0; i < count; ++i) {
    CamDesign& design = result.designs[i];
    const Run part = part_of(run, double(i) / double(count), double(i + 1) / double(count));
    design.tolerance = tolerances_of(problem, design, part, deadline);
    std::ranges::move(tolerance_quantities(*design.tolerance), std::back_inserter(design.metrics));
  }
  if (problem.second.closure != cam::Closure::force) {
    result.notes.emplace_back(
        "Tolerances are of the first contact: the play of the second is not looked at.");
  }
}

}  // namespace cognate::problems
