#include "problems/tolerance/read.hpp"

#include <fmt/core.h>

#include <cmath>
#include <vector>

#include "problems/layers/link_names.hpp"
#include "problems/linkage/read_constraints.hpp"
#include "problems/linkage/read_linkage.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/straight_line/keys.hpp"
#include "problems/straight_line/problem.hpp"
#include "problems/straight_line/read_raster.hpp"
#include "problems/straight_line/read_search.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kCrankAngle = "crank_deg";

/// Whether the file uses the theory of contact.
bool read_method(TableReader& target) {
  constexpr std::string_view kMethods[] = {"exact"};
  target.choice_of("method", kMethods);
  if (!target.has("method")) return false;
  const auto refuse_goal = [&](std::string_view key) {
    if (!target.has(key)) return;
    target.fault(key,
                 "is given with method = \"exact\", which knows curvature alone; remove it, or "
                 "remove method for a search");
  };
  for (const auto& key : kGoalKeys) refuse_goal(key.in_table());
  refuse_goal("constant_velocity");
  return true;
}

/// A key that belongs to other arrangements.
void refuse(TableReader& mechanism, std::string_view key, std::string_view why) {
  if (mechanism.has(key)) mechanism.fault(key, fmt::format("{}; remove it", why));
}

void read_angle(TableReader& mechanism, std::string_view key, double& angle) {
  const auto degrees = mechanism.number(key, kAngle);
  if (degrees) angle = radians(*degrees);
}

void read_position(TableReader& mechanism, StraightLineProblem& problem) {
  const auto degrees = mechanism.number(kCrankAngle, kAngle);
  if (degrees) problem.crank_angle = radians(*degrees);
}

void require(TableReader& mechanism, std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys) {
    if (mechanism.has(key)) continue;
    mechanism.fault(key, fmt::format("is missing; expected {}", kLength.allowed));
  }
}

std::vector<std::string_view> missing_lengths(TableReader& mechanism) {
  std::vector<std::string_view> missing;
  for (const std::string_view key : {"crank", "coupler", "rocker"}) {
    if (!mechanism.has(key)) missing.push_back(key);
  }
  const bool pivots = mechanism.has("pivot_a") && mechanism.has("pivot_d");
  if (!mechanism.has("frame") && !mechanism.has("fixed_pivots") && !pivots) {
    missing.push_back("frame");
  }
  return missing;
}

void check_missing(TableReader& mechanism, const std::vector<std::string_view>& missing,
                   const StraightLineProblem& problem) {
  if (missing.size() > 1) {
    for (const std::string_view key : missing) {
      mechanism.fault(key,
                      "is missing; expected all lengths, or all but one, which is then chosen "
                      "for contact = 5");
    }
  } else if (missing.size() == 1 && problem.contact < 5) {
    mechanism.fault(missing.front(),
                    "is missing; expected only for contact = 5 is a length chosen, all");
  }
}

void read_any_cranks(TableReader& mechanism, StraightLineProblem& problem) {
  read_given_places(mechanism, problem.given);
  read_position(mechanism, problem);
  const auto missing = missing_lengths(mechanism);
  check_missing(mechanism, missing, problem);
  if (mechanism.has(kCrankAngle)) return;
  if (problem.contact < 5) {
    mechanism.fault(kCrankAngle,
                    "is missing; expected contact of three or four points exists in every "
                    "position, one (contact = 5 chooses it)");
  } else if (missing.size() == 1) {
    mechanism.fault(kCrankAngle,
                    "is missing beside a length; give one of them, the other is found");
  }
}

void read_symmetric_cranks(TableReader& mechanism, StraightLineProblem& problem) {
  std::vector<std::string_view> missing;
  for (const std::string_view key : {"crank", "coupler", "frame"}) {
    if (!mechanism.has(key)) missing.push_back(key);
  }
  check_missing(mechanism, missing, problem);
  refuse(mechanism, "rocker",
         "is given, but symmetric cranks are of one length, that of crank; remove it");
  refuse(mechanism, kCrankAngle,
         "is given, but the symmetric position follows from the lengths; remove it");
}

void read_parallel_cranks(TableReader& mechanism, StraightLineProblem& problem) {
  require(mechanism, {"crank", "coupler", "rocker"});
  refuse(mechanism, "frame",
         "is given, but that of parallel cranks follows from their position; remove it");
  refuse(mechanism, "assembly",
         "is given, but that of parallel cranks follows from sides; remove it");
  const auto sides = mechanism.choice_of("sides", kCrankSides);
  if (!mechanism.has("sides")) {
    mechanism.fault("sides",
                    "is missing; expected \"same\" or \"opposite\", the sides to which "
                    "the cranks point");
  }
  problem.sides = static_cast<CrankSides>(sides.value_or(0));
  read_angle(mechanism, "coupler_angle_deg", problem.coupler_angle);
  read_position(mechanism, problem);
}

void read_four_bar(TableReader& mechanism, StraightLineProblem& problem) {
  read_given_links(mechanism, problem.given);
  const auto cranks = mechanism.choice_of("cranks", kCrankArrangements);
  problem.cranks = static_cast<CrankArrangement>(cranks.value_or(0));
  if (problem.cranks == CrankArrangement::any) read_any_cranks(mechanism, problem);
  if (problem.cranks == CrankArrangement::symmetric) read_symmetric_cranks(mechanism, problem);
  if (problem.cranks == CrankArrangement::parallel) read_parallel_cranks(mechanism, problem);
  refuse(mechanism, "coupler_point", "is given, but it is what is sought; remove it");
  problem.given.coupler_point.reset();
  check_given(mechanism, problem.given, {});
}

void read_slider_crank(TableReader& mechanism, StraightLineProblem& problem) {
  require(mechanism, {"crank", "coupler"});
  problem.given.crank = mechanism.number("crank", kLinkLength);
  problem.given.coupler = mechanism.number("coupler", kLinkLength);
  problem.given.assembly = mechanism.choice<Assembly>("assembly");
  problem.given.pivot_a = mechanism.point("pivot");
  SliderGuide slider;
  slider.offset = mechanism.number("offset", kQuantity).value_or(0);
  read_angle(mechanism, "direction_deg", slider.direction);
  problem.slider = slider;
  read_position(mechanism, problem);
  if (!mechanism.has(kCrankAngle) && problem.contact == 3) {
    mechanism.fault(kCrankAngle,
                    "is missing; expected contact of three points exists in every position, one");
  }
}

}  // namespace

}  // namespace cognate::problems::reading

namespace cognate::problems {

StraightLineProblem KindTraits<StraightLineProblem>::read(reading::TableReader& document,
                                                          const std::filesystem::path& /*folder*/) {
  using namespace reading;
  StraightLineProblem problem;
  TableReader target = document.table("target");
  if (!read_method(target)) {
    problem = read_straight_line_search(document);
    problem.warnings = read_warnings(document);
    return problem;
  }
  TableReader mechanism = document.table("mechanism");
  TableReader constraints = document.table("constraints");
  TableReader solve = document.table("solve");

  problem.contact = target.integer("contact", 3, 5).value_or(problem.contact);
  constexpr std::string_view kTypes[] = {"four-bar", "slider-crank"};
  const bool slides = mechanism.choice_of("type", kTypes).value_or(0) == 1;
  if (slides) {
    read_slider_crank(mechanism, problem);
  } else {
    read_four_bar(mechanism, problem);
  }
  read_link_constraints(constraints, length_limits(problem.given, {}), problem.constraints);
  read_pivot_region(constraints, problem.given, problem.constraints);
  constexpr int kAll = 100;
  problem.solve.designs = solve.integer("designs", 1, kAll).value_or(kAll);

  problem.layers = read_design_layers(document, constraints,
                                      slides ? links_of<SliderCrank>() : links_of<FourBar>());
  problem.tolerances = read_tolerances(document, slides ? slider_crank_scope() : four_bar_scope());
  refuse_raster_of_contact(document);
  for (TableReader* table : {&target, &mechanism, &constraints, &solve}) table->finish();
  problem.warnings = read_warnings(document);
  return problem;
}

}  // namespace cognate::problems
