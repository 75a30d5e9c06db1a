#include "problems/chain/front/front.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/chain/found_designs.hpp"
#include "problems/chain/front/measures.hpp"
#include "problems/chain/verify.hpp"
#include "problems/linkage/verify.hpp"
#include "synthesis/search/pareto_front.hpp"

namespace cognate::problems {
namespace {

constexpr double kSameError = 1e-9;   ///< relative differences up to this are what fits leave open
constexpr double kSameLevels = 1e-3;  ///< of a front's: levels that differ by less are one
/// Of each search along a front but the first, which have the designs beside them to go on from.
constexpr int kStartsAlong = 2048;
constexpr int kMinimaAlong = 6;  ///< under each bound, from which its neighbours are begun
constexpr int kMostSteps = 40;   ///< between the levels first looked at
constexpr std::string_view kLinksColumn = "link_count";

bool is_sound(const Result& found) {
  return !found.designs.empty() && all_satisfied(found.designs.front().constraints);
}

void add_work(const Work& done, Work& work) {
  work.candidates += done.candidates;
  work.positions += done.positions;
  work.gradients += done.gradients;
  work.solver_iterations += done.solver_iterations;
}

struct Point {
  Design design;
  double measure = 0;  ///< as tables say it
};

/// `points`: best error first. `nearest`: what was found where there is none.
Result front_of(const ChainFrontProblem& problem, std::vector<Point> points, Result nearest,
                std::string_view column, const Deadline& deadline) {
  Result result = std::move(nearest);
  result.quantities.clear();
  Family family{"Pareto front", {{std::string(column), {}}, {problem.error, {}}}};
  if (!points.empty()) result.designs.clear();
  for (Point& point : points) {
    family.columns[0].values.push_back(point.measure);
    family.columns[1].values.push_back(problem.shown(point.design));
    result.designs.push_back(std::move(point.design));
  }
  if (!points.empty()) result.families = {std::move(family)};
  result.status = status_of(result.designs, deadline);
  return result;
}

/// The best design of each number of links.
class LinkFront {
 public:
  LinkFront(const ChainFrontProblem& problem, const Run& run, const Deadline& deadline)
      : problem_(problem), run_(run), deadline_(deadline) {
    for (const Topology& topology : problem.demand.topologies) {
      const int links = link_count(topology);
      by_count_[links].push_back(topology);
      effort_ += effort_of(links);
    }
  }

  Result result() && {
    for (const auto& [links, topologies] : by_count_) {
      const bool is_met = !points_.empty() && best() <= problem_.met;
      if (is_met || deadline_.reached()) break;
      search(links, topologies);
    }
    nearest_.work = work_;
    Result result =
        front_of(problem_, std::move(points_), std::move(nearest_), kLinksColumn, deadline_);
    if (is_cut_short_ && result.status != Status::interrupted) result.status = Status::time_limit;
    result.quantities = {{"problems_solved", double(searched_)}};
    for (std::string& note : notes_) result.notes.push_back(std::move(note));
    return result;
  }

 private:
  /// What the search of a topology takes, relative to others: steps of as many dimensions as lines,
  /// each over as many lines.
  static double effort_of(int links) { return double(links) * double(links); }

  /// In an equal share of the time that is left.
  void search(int links, const std::vector<Topology>& topologies) {
    ChainDemand own = problem_.demand;
    own.topologies = topologies;
    const double left = double(by_count_.size()) - double(searched_++);
    const double from = done_ / effort_;
    done_ += effort_of(links) * double(topologies.size());
    Run part = part_of(run_, from, done_ / effort_);
    if (run_.time_limit) part.time_limit = deadline_.remaining() / left;
    Result found = problem_.solve(own, part, Deadline(part));
    add_work(found.work, work_);
    const bool is_cut = found.status == Status::time_limit || found.status == Status::interrupted;
    is_cut_short_ = is_cut_short_ || is_cut;
    if (is_sound(found)) {
      take(links, std::move(found.designs.front()));
      return;
    }
    if (!is_cut_short_) {
      notes_.push_back(fmt::format("No chain of {} links was found within the limits.", links));
    }
    const double least =
        nearest_.designs.empty() ? kInfinity : problem_.ranked(nearest_.designs.front());
    if (found.designs.empty() || problem_.ranked(found.designs.front()) > least) return;
    nearest_ = std::move(found);
  }

  double best() const { return problem_.ranked(points_.front().design); }

  /// More links are worth their price where they come nearer.
  void take(int links, Design design) {
    if (points_.empty() || problem_.ranked(design) < (1 - kSameError) * best()) {
      design.metrics.quantities.push_back({std::string(kLinksColumn), double(links)});
      points_.insert(points_.begin(), {std::move(design), double(links)});
    } else if (!is_cut_short_) {
      notes_.push_back(fmt::format(
          "No chain of {} links was found that comes nearer than one of fewer.", links));
    }
  }

  const ChainFrontProblem& problem_;
  const Run& run_;
  const Deadline& deadline_;
  std::map<int, std::vector<Topology>> by_count_;
  std::vector<Point> points_;  ///< best error, most links first
  std::vector<std::string> notes_;
  Result nearest_;
  Work work_;
  double effort_ = 0, done_ = 0;
  int searched_ = 0;
  bool is_cut_short_ = false;
};

/// Points whose levels differ by less than a thousandth of the front's are one, that of less error.
std::vector<synthesis::FrontPoint> spread(const std::vector<synthesis::FrontPoint>& points) {
  std::vector<synthesis::FrontPoint> apart;
  for (const auto& point : points) {
    const double least = kSameLevels * (points.back().level - points.front().level);
    if (apart.empty() || point.level - apart.back().level > least) apart.push_back(point);
  }
  return apart;
}

/// The front of a measure that has any value, by a row of bounds.
class BoundedFront {
 public:
  BoundedFront(const ChainFrontProblem& problem, const Run& run, const Deadline& deadline)
      : problem_(problem), rule_(rule_of(problem.against)), run_(run), deadline_(deadline) {}

  Result result() && {
    run_.enter(Phase::front, kUnknownEnd);
    const synthesis::FrontProblem front{
        synthesis::measure_of_values(rule_.greatest_is_best, rule_.best), problem_.met,
        [this](std::optional<double> bound, const std::vector<std::size_t>& known,
               std::optional<std::uint64_t> seed) { return solve(bound, known, seed); }};
    synthesis::FrontSearch search(front, {run_.seed, deadline_, run_.progress});
    search.begin();
    if (!search.points().empty()) {
      step_along(search);
      search.fill(problem_.demand.solve.designs);
    }
    std::vector<Point> points;
    for (const auto& point : spread(search.points())) {
      Design& design = all_[point.design().number];
      check_own_limit(design);
      points.push_back({std::move(design), rule_.shown(point.design().value)});
    }
    Result result =
        front_of(problem_, std::move(points), std::move(first_), rule_.column, deadline_);
    result.work = work_;
    result.quantities = {{"problems_solved", double(search.searches())}};
    return result;
  }

 private:
  /// In shorter steps where the first leads beyond the front's end.
  void step_along(synthesis::FrontSearch& search) const {
    constexpr double kShorter = 0.25;
    constexpr int kAttempts = 3;
    const double first = search.points().front().level;
    double step = rule_.step;
    for (int i = 0; i < kAttempts && search.points().size() < 2; ++i, step *= kShorter) {
      search.step(first + step, step, kMostSteps, problem_.most);
    }
  }

  std::optional<std::vector<synthesis::FrontDesign>> solve(std::optional<double> bound,
                                                           const std::vector<std::size_t>& known,
                                                           std::optional<std::uint64_t> seed) {
    ChainDemand own = problem_.demand;
    own.solve.designs = kMinimaAlong;
    if (bound && !rule_.limit(own, *bound)) return std::nullopt;
    if (!known.empty() && !own.solve.starts) own.solve.starts = kStartsAlong;
    if (!seed) own.solve.starts = 0;
    Run part = silent(run_);
    part.seed = seed.value_or(run_.seed);
    for (const std::size_t one : known) part.known.push_back(all_[one]);
    Result found = problem_.solve(own, part, deadline_);
    add_work(found.work, work_);
    const bool is_first = all_.empty();
    std::vector<synthesis::FrontDesign> designs;
    if (is_sound(found) && (is_first || !deadline_.reached())) {
      for (const Design& design : found.designs) {
        designs.push_back({all_.size(), rule_.value(problem_.demand.topologies, design),
                           problem_.ranked(design)});
        all_.push_back(design);
      }
    }
    if (is_first) first_ = std::move(found);
    return designs;
  }

  /// The limit of the file in place of that of the search.
  void check_own_limit(Design& design) const {
    if (rule_.measure != ChainMeasure::transmission_angle) {
      design.metrics.quantities.push_back(
          {std::string(rule_.column), rule_.value(problem_.demand.topologies, design)});
      return;
    }
    std::erase_if(design.constraints, [](const ConstraintCheck& check) {
      return check.name == "transmission_angle_deg";
    });
    check_transmission(problem_.demand.transmission_angle, design);
  }

  const ChainFrontProblem& problem_;
  const ChainMeasureRule& rule_;
  const Run& run_;
  const Deadline& deadline_;
  std::vector<Design> all_;
  Result first_;
  Work work_;
};

}  // namespace

Result chain_front(const ChainFrontProblem& problem, const Run& run, const Deadline& deadline) {
  return problem.against == ChainMeasure::links ? LinkFront(problem, run, deadline).result()
                                                : BoundedFront(problem, run, deadline).result();
}

}  // namespace cognate::problems
