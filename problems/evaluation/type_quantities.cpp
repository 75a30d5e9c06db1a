#include "problems/evaluation/type_quantities.hpp"

#include <array>
#include <string>
#include <string_view>
#include <variant>

#include "analysis/linkage/change_point.hpp"
#include "analysis/linkage/guide_bar_mobility.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/slider_crank_mobility.hpp"
#include "analysis/mechanism/joints.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/linkage_keys.hpp"

namespace cognate::problems {
namespace {

using Quantities = std::vector<Quantity>;

Quantities rotation_quantities(std::string_view name, bool change_point, bool crank_turns) {
  return {quantity(kClassKey, std::string(name)), quantity(kChangePointKey, change_point),
          quantity(kCrankTurnsKey, crank_turns)};
}

std::string chain_name(const Mechanism<double>& mechanism) {
  constexpr std::array<std::string_view, 7> kTypes = {"RRR", "RRP",      "RPR",  "PRP",
                                                      "RPP", "cylinder", "group"};
  std::string text;
  for (const auto& dyad : mechanism.dyads) {
    if (std::holds_alternative<GroupRest>(dyad)) continue;
    if (!text.empty()) text += '+';
    text += kTypes.at(dyad.index());
  }
  return text + " chain";
}

std::string_view name(ChangePointPath path) {
  switch (path) {
    case ChangePointPath::parallelogram:
      return "parallelogram";
    case ChangePointPath::antiparallelogram:
      return "antiparallelogram";
    case ChangePointPath::deltoid:
      return "deltoid";
    case ChangePointPath::folded:
      return "folded kite";
    case ChangePointPath::single:
      break;
  }
  return "both assemblies in turn";
}

/// Facts of the dimensions that a file gives.
struct QuantitiesOf {
  const NamedMechanism& mechanism;
  double start = 0;

  Quantities operator()(const FourBar& linkage) const {
    const auto links = lengths(linkage);
    Quantities quantities = rotation_quantities(to_string(mobility_class(links)),
                                                is_change_point(links), crank_rotates(links));
    quantities.push_back({"rocker_turns_fully", rocker_rotates(links)});
    if (const auto motion = ChangePointMotion::through(linkage, start)) {
      quantities.push_back(
          quantity(kChangePointKindKey, std::string(change_point_kind(linkage, start))));
      quantities.push_back({"moves_as", std::string(name(motion->path()))});
    }
    return quantities;
  }
  Quantities operator()(const ChainDescription&) const {
    return {quantity(kClassKey, chain_name(mechanism.mechanism))};
  }
  template <class Type>
  Quantities operator()(const Type& described) const {
    const auto& dimensions = dimensions_of_formulas(described);
    if constexpr (requires { mobility_class(dimensions); }) {
      return rotation_quantities(name(mobility_class(dimensions)), is_change_point(dimensions),
                                 crank_rotates(dimensions));
    } else {
      return {quantity(kClassKey, std::string(to_string(mechanism.type())))};
    }
  }
};

/// 3 (bodies − 1) − 2 joints (Grübler), each joint turning or sliding.
double mobility(const Mechanism<double>& mechanism) {
  const auto joint_count = static_cast<int>(joints(mechanism).joints.size());
  return 3 * (body_count(mechanism) - 1) - 2 * joint_count;
}

}  // namespace

Quantities type_quantities(const NamedMechanism& mechanism, double start) {
  Quantities quantities = std::visit(QuantitiesOf{mechanism, start}, mechanism.description);
  quantities.push_back(quantity(kMobilityKey, mobility(mechanism.mechanism)));
  return quantities;
}

}  // namespace cognate::problems
