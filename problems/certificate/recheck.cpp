#include "problems/certificate/recheck.hpp"

#include <algorithm>
#include <atomic>

#include "analysis/numbers/constants.hpp"
#include "problems/certificate/subdivision.hpp"
#include "problems/linkage/certifying.hpp"

namespace cognate::problems {
namespace {

using synthesis::ProportionBox;
using synthesis::Proportions;

constexpr int kMostDepth = 60;    // of the parts of a sampled box
constexpr int kMostParts = 8000;  // of one of them

/// One for each sense of the crank, as a proof has them.
std::vector<PathBoxes> boxes_of_senses(const PathProblem& problem, double bound) {
  const bool increments = problem.crank_reference == CrankReference::first;
  std::vector<PathBoxes> boxes;
  if (!increments || problem.crank_sense != CrankSense::cw)
    boxes.emplace_back(problem, false, bound);
  if (increments && problem.crank_sense != CrankSense::ccw)
    boxes.emplace_back(problem, true, bound);
  return boxes;
}

/// What became of one sampled box.
struct Look {
  int parts = 0;
  bool confirmed = false;
  bool ended = false;  ///< before anything was found
  std::optional<Counterexample> refutation;
};

/// Divides `whole` until every part is shown to hold nothing better, or there are too many.
Look look(const PathBoxes& boxes, const QuadBox& whole, const std::function<bool()>& ends) {
  std::vector<std::pair<QuadBox, int>> open{{whole, 0}};
  Look found;
  while (!open.empty()) {
    if (ends()) {
      found.ended = true;
      return found;
    }
    const auto [box, depth] = open.back();
    open.pop_back();
    ++found.parts;
    const BoxFinding finding = boxes(box);
    if (finding.shown) continue;
    found.refutation = boxes.counterexample(box);
    if (found.refutation || depth == kMostDepth || found.parts >= kMostParts) return found;
    for (const QuadBox& part : box.halves(finding.side)) open.emplace_back(part, depth + 1);
  }
  found.confirmed = true;
  return found;
}

/// Looks at the boxes of `sample` until one is refuted or `options` end it.
std::vector<Look> look_at_all(const std::vector<PathBoxes>& boxes,
                              const std::vector<PathPart>& sample, const RecheckOptions& options) {
  std::atomic<bool> is_refuted = false;
  std::atomic<std::size_t> done = 0;
  const auto ends = [&] { return is_refuted || (options.stop && options.stop()); };
  std::vector<Look> looks(sample.size());
  parallel_for(static_cast<int>(looks.size()), options.threads, [&](int i, int thread) {
    looks[i] = look(boxes[sample[i].sense], QuadBox(sample[i].box), ends);
    if (looks[i].refutation) is_refuted = true;
    ++done;
    if (thread == 0 && options.progress) {
      options.progress(0.5 + 0.5 * double(done) / double(looks.size()));
    }
  });
  return looks;
}

/// Ranges of the proportions and the phase that a root box must hold.
std::array<QuadInterval, 4> wanted_sides(const PathProblem& problem, Proportions proportions) {
  const auto lengths = path_lengths(problem);
  const Quad ratio = path_ratio(problem);
  const Range &crank = lengths[0], &frame = lengths[3];
  Quad most = ratio, least = 1 / ratio;
  if (std::isfinite(frame.max) && crank.min > 0)
    most = std::min<Quad>(most, Quad(frame.max) / crank.min);
  if (std::isfinite(crank.max)) least = std::max<Quad>(least, Quad(frame.min) / crank.max);
  std::array<QuadInterval, 4> sides;
  sides[0] = {least / (1 + least), most / (1 + most)};
  const Quad half_turn = quad_turn() / 2;
  if (proportions == Proportions::any) {
    sides[1] = {-1, 1};
    sides[2] = {0, ratio / (1 + ratio)};
  } else {
    const bool crank_shortest = proportions == Proportions::crank_shortest;
    sides[0] = crank_shortest ? QuadInterval(std::max<Quad>(0.5, sides[0].low), sides[0].high)
                              : QuadInterval(sides[0].low, std::min<Quad>(0.5, sides[0].high));
    sides[1] = {0, half_turn};
    sides[2] = {0, half_turn / 2};
  }
  const Given& given = problem.given;
  const bool has_frame = given.frame_angle || (given.pivot_a && given.pivot_d);
  const bool free_phase = problem.crank_reference == CrankReference::first ||
                          (problem.crank_reference == CrankReference::global && !has_frame);
  if (free_phase) sides[3] = {0, quad_turn()};
  return sides;
}

Proportions proportions_of_class(const PathProblem& problem) {
  if (!problem.constraints.required_class) return Proportions::any;
  return *problem.constraints.required_class == RequiredClass::crank_rocker
             ? Proportions::crank_shortest
             : Proportions::frame_shortest;
}

}  // namespace

std::string recheck_refusal(const PathProblem& problem) {
  const auto& required = problem.constraints.required_class;
  const bool turns = required && (*required == RequiredClass::crank_rocker ||
                                  *required == RequiredClass::double_crank);
  if (turns || (!required && !problem.constraints.transmission_angle)) return {};
  return "its class and transmission angle are not checked again; allowed are the classes "
         "crank-rocker and double-crank, or none without transmission_angle_deg";
}

bool covers_domain(const PathProblem& problem, const PathDomain& domain) {
  const auto wanted = wanted_sides(problem, proportions_of_class(problem));
  const bool one_phase = wanted[3].low == wanted[3].high;
  if (wanted[0].low > wanted[0].high) return true;
  const auto holds = [&](const ProportionBox& root) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (i == 3 && one_phase) continue;
      if (Quad(root.side[i].low) > wanted[i].low || Quad(root.side[i].high) < wanted[i].high) {
        return false;
      }
    }
    return root.proportions == proportions_of_class(problem);
  };
  const auto has = [&](Assembly assembly) {
    return std::ranges::any_of(domain.roots, [&](const ProportionBox& root) {
      return root.assembly == (assembly == Assembly::open ? 1 : -1) && holds(root);
    });
  };
  const auto& given = problem.given.assembly;
  const bool both = (given == Assembly::crossed || has(Assembly::open)) &&
                    (given == Assembly::open || has(Assembly::crossed));
  return both && domain.bounds.size() == boxes_of_senses(problem, 0).size();
}

Recheck recheck(const PathProblem& problem, double bound, const RecheckOptions& options) {
  const PathDomain domain = path_domain(problem);
  const double target = bound / domain.to_file;
  SubdivisionOptions subdividing{options.sample, options.seed, options.threads, options.stop, {}};
  if (options.progress) {
    subdividing.progress = [&](double share) { options.progress(0.5 * share); };
  }
  const auto found = subdivision(
      whole_parts(domain), subdividing,
      [&](std::span<const PathPart> parts, std::span<synthesis::StageVerdict> verdicts) {
        judge(domain, parts, target, target, verdicts);
      },
      [](const PathPart& part, int side) { return halves(part, side); });
  Recheck result{found.boxes, found.discarded, found.complete,
                 found.covers && covers_domain(problem, domain), found.sample.size()};
  for (const Look& look : look_at_all(boxes_of_senses(problem, bound), found.sample, options)) {
    result.parts += static_cast<std::uint64_t>(look.parts);
    if (look.refutation && !result.refutation) result.refutation = look.refutation;
    if (look.ended) continue;
    ++result.sampled;
    if (look.refutation) continue;
    ++(look.confirmed ? result.confirmed : result.undecided);
  }
  return result;
}

std::optional<Counterexample> better_linkage(const PathProblem& problem, double bound,
                                             const std::vector<Counterexample>& linkages) {
  std::vector<PathQuestion> questions;
  const bool increments = problem.crank_reference == CrankReference::first;
  if (!increments || problem.crank_sense != CrankSense::cw)
    questions.push_back(path_question(problem, false));
  if (increments && problem.crank_sense != CrankSense::ccw)
    questions.push_back(path_question(problem, true));
  for (Counterexample linkage : linkages) {
    for (const PathQuestion& question : questions) {
      const double first = static_cast<double>(question.angles.front().angle);
      linkage.error = path_error(question, linkage.linkage, linkage.first_crank_angle - first);
      if (linkage.error < bound) return linkage;
    }
  }
  return std::nullopt;
}

}  // namespace cognate::problems
