#include "problems/linkage/design_tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/mechanism/joint_names.hpp"

namespace cognate::problems {
namespace {

constexpr int kMotionSteps = 360;
constexpr std::size_t kMostDesigns = 10;

/// The range of the crank that holds most of the angles; those not in it cannot be reached.
DriveRange range_of(const NamedMechanism& mechanism, const std::vector<double>& angles) {
  DriveRange best{0, kTurn};
  std::ptrdiff_t most = -1;
  for (const DriveRange& range : ranges_over_a_turn(mechanism.mechanism)) {
    const auto held = std::ranges::count_if(angles, [&](double angle) {
      return in_one_turn(angle - range.from) <= range.to - range.from;
    });
    if (held > most) {
      most = held;
      best = range;
    }
  }
  return best;
}

void add(std::vector<Quantity>& all, const std::string& name, bool angle, double value) {
  if (std::isfinite(value)) all.push_back({angle ? name + "_deg" : name, value});
}

}  // namespace

DesignQuestion question_at(const NamedMechanism& mechanism, const std::vector<double>& angles) {
  DesignQuestion result;
  ToleranceQuestion& question = result.question;
  if (driven_by_length(mechanism.mechanism.drive)) return result;
  const DriveRange range = range_of(mechanism, angles);
  const AssemblyRanges ranges = follow(mechanism.mechanism, range.from, range.to);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double drive = range.from + in_one_turn(angles[i] - range.from);
    const std::size_t before = question.stations.size();
    add_stations(mechanism.mechanism, ranges, std::span(&drive, 1), question.drive,
                 question.stations);
    if (question.stations.size() > before) result.kept.push_back(i);
  }
  std::vector<double> drives;
  for (int k = 0; k <= kMotionSteps; ++k) {
    drives.push_back(range.from + (range.to - range.from) * k / kMotionSteps);
  }
  const bool whole = range.to - range.from >= kTurn - kEpsilon;
  if (!whole && !question.drive.empty()) {
    const auto [least, greatest] = std::ranges::minmax(question.drive);
    for (int k = 0; k <= kMotionSteps; ++k) {
      drives[std::size_t(k)] = least + (greatest - least) * k / kMotionSteps;
    }
  }
  add_stations(mechanism.mechanism, ranges, drives, question.motion_drive, question.motion);
  return result;
}

std::optional<Response> point_response(const NamedMechanism& mechanism, std::string_view name) {
  const auto found = std::ranges::find(mechanism.points, name, &NamedPoint::name);
  if (found == mechanism.points.end()) return std::nullopt;
  Response response;
  response.type = ResponseType::point;
  response.index = static_cast<std::size_t>(found - mechanism.points.begin());
  return response;
}

PathFrame path_frame(const NamedMechanism& mechanism, const ToleranceQuestion& question,
                     const Response& point) {
  PathFrame frame;
  const auto& [name, at] = mechanism.points[point.index];
  MechanismMotion<1> motion(mechanism.mechanism);
  for (const Station& station : question.stations) {
    std::ranges::copy(station.sides, motion.sides().begin());
    motion.move_to(station.drive);
    const auto moved = motion.point(at);
    frame.place.push_back(moved[0]);
    const double speed = norm(moved[1]);
    frame.normal.push_back(speed > 0 ? (1 / speed) * perp(moved[1]) : Vec2d{1, 0});
  }
  return frame;
}

std::optional<ToleranceQuestion> error_at_targets(const NamedMechanism& mechanism,
                                                  std::string_view name,
                                                  const std::vector<double>& angles,
                                                  const std::vector<Vec2d>& targets, bool timed) {
  const auto point = point_response(mechanism, name);
  if (!point || angles.size() != targets.size()) return std::nullopt;
  auto [question, kept] = question_at(mechanism, angles);
  question.left_out = angles.size() - kept.size();
  ToleranceQuantity error{.name = "error", .response = *point, .judged = true};
  const PathFrame frame = path_frame(mechanism, question, *point);
  for (std::size_t s = 0; s < kept.size(); ++s) {
    const Vec2d& target = targets[kept[s]];
    if (timed) {
      error.target.push_back(target);
    } else {
      error.normal.push_back(frame.normal[s]);
      error.offset.push_back(dot(frame.place[s] - target, frame.normal[s]));
    }
  }
  question.quantities.push_back(std::move(error));
  add_transmissions(mechanism, question);
  return std::move(question);
}

std::optional<ToleranceQuestion> output_over_motion(const NamedMechanism& mechanism,
                                                    const std::vector<double>& angles) {
  ToleranceQuestion question = question_at(mechanism, angles).question;
  question.stations = question.motion;
  question.drive = question.motion_drive;
  question.quantities.push_back(
      {.name = mechanism.bodies[static_cast<std::size_t>(mechanism.output)],
       .response = travel_response(mechanism.mechanism, mechanism.output),
       .judged = true});
  add_transmissions(mechanism, question);
  return question;
}

void add_transmissions(const NamedMechanism& mechanism, ToleranceQuestion& question) {
  const auto names = dyad_names(mechanism);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& dyad = mechanism.mechanism.dyads[i];
    if (std::holds_alternative<Prp<double>>(dyad) || std::holds_alternative<Rpp<double>>(dyad)) {
      continue;
    }
    ToleranceQuantity transmission{.name = names[i] + " transmission"};
    transmission.response.type = ResponseType::transmission;
    transmission.response.index = i;
    question.quantities.push_back(std::move(transmission));
  }
}

void add_tolerances(
    const std::optional<Tolerances>& tolerances, std::optional<LengthUnit> unit, const Run& run,
    const std::function<std::optional<ToleranceQuestion>(const Design&)>& question_of,
    Result& result) {
  if (!tolerances) return;
  run.enter(Phase::tolerances, kUnknownEnd);
  const std::size_t count = std::min(result.designs.size(), kMostDesigns);
  for (std::size_t i = 0; i < count; ++i) {
    Design& design = result.designs[i];
    const auto question = question_of(design);
    if (!question) continue;
    ToleranceRun own{.seed = run.seed, .threads = run.threads};
    own.stop = [&] { return run.interrupted != nullptr && *run.interrupted; };
    design.tolerance = tolerance_figures(design.mechanism, *tolerances, unit, *question, own);
    std::ranges::move(tolerance_quantities(*design.tolerance),
                      std::back_inserter(design.metrics.quantities));
  }
  if (count < result.designs.size()) {
    result.notes.emplace_back("Tolerances were computed for the first ten designs.");
  }
}

std::vector<Quantity> tolerance_quantities(const ToleranceResult& result) {
  std::vector<Quantity> all;
  for (const ToleranceFigures& figures : result.quantities) {
    if (!figures.judged || figures.positions.empty()) continue;
    const bool angle = figures.angle;
    add(all, "tolerance_linear", angle, figures.positions[figures.worst].linear);
    if (figures.exact) {
      const PositionFigures& at = figures.positions[figures.worst_exact];
      add(all, "tolerance_exact", angle, std::max(at.high, -at.low));
    }
    double rss = 0, sigma = 0;
    for (const PositionFigures& at : figures.positions) {
      rss = std::max(rss, at.rss);
      sigma = std::max(sigma, at.sigma);
    }
    add(all, "tolerance_rss", angle, rss);
    if (result.assembled > 1) add(all, "tolerance_sigma", angle, sigma);
    for (const Quantile& quantile : figures.quantiles) {
      if (quantile.share == 0.99) add(all, "tolerance_q99", angle, quantile.error);
    }
    if (result.clearance_linear) add(all, "tolerance_clearance", angle, *result.clearance_linear);
  }
  if (result.yield) all.push_back({"tolerance_yield", *result.yield});
  if (result.samples > 0) {
    all.push_back({"tolerance_assembled",
                   static_cast<double>(result.assembled) / static_cast<double>(result.samples)});
  }
  if (result.allocation_cost) all.push_back({"tolerance_cost", *result.allocation_cost});
  return all;
}

}  // namespace cognate::problems
