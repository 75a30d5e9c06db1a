#include "problems/evaluation/type_facts.hpp"

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

namespace cognate::problems {
namespace {

using Facts = std::vector<Fact>;

Facts rotation_facts(std::string_view name, bool change_point, bool crank_turns) {
  return {{"class", std::string(name)},
          {"change_point", change_point},
          {"crank_turns_fully", crank_turns}};
}

std::string chain_name(const Mechanism<double>& mechanism) {
  constexpr std::array<std::string_view, 5> kTypes = {"RRR", "RRP", "RPR", "PRP", "RPP"};
  std::string text;
  for (const auto& dyad : mechanism.dyads) {
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
struct FactsOf {
  const NamedMechanism& mechanism;
  double start = 0;

  Facts operator()(const FourBar& linkage) const {
    const auto links = lengths(linkage);
    Facts facts = rotation_facts(to_string(mobility_class(links)), is_change_point(links),
                                 crank_rotates(links));
    facts.push_back({"rocker_turns_fully", rocker_rotates(links)});
    if (const auto motion = ChangePointMotion::through(linkage, start)) {
      facts.push_back({"change_point_kind", std::string(change_point_kind(linkage, start))});
      facts.push_back({"moves_as", std::string(name(motion->path()))});
    }
    return facts;
  }
  Facts operator()(const SliderCrank& dimensions) const {
    return rotation_facts(name(mobility_class(dimensions)), is_change_point(dimensions),
                          crank_rotates(dimensions));
  }
  Facts operator()(const GuideBar& dimensions) const {
    return rotation_facts(name(mobility_class(dimensions)), is_change_point(dimensions),
                          crank_rotates(dimensions));
  }
  Facts operator()(const FixedBlock& dimensions) const {
    return (*this)(as_slider_crank(dimensions));
  }
  Facts operator()(const OscillatingBlock& dimensions) const {
    return (*this)(as_guide_bar(dimensions));
  }
  Facts operator()(const ChainDescription&) const {
    return {{"class", chain_name(mechanism.mechanism)}};
  }
  template <class DoubleSlider>
  Facts operator()(const DoubleSlider&) const {
    return {{"class", std::string(to_string(mechanism.type))}};
  }
};

/// 3 (bodies − 1) − 2 joints (Grübler), each joint turning or sliding.
double mobility(const Mechanism<double>& mechanism) {
  const auto joint_count = static_cast<int>(joints(mechanism).joints.size());
  return 3 * (body_count(mechanism) - 1) - 2 * joint_count;
}

}  // namespace

Facts type_facts(const NamedMechanism& mechanism, double start) {
  Facts facts = std::visit(FactsOf{mechanism, start}, mechanism.description);
  facts.push_back({"mobility", mobility(mechanism.mechanism)});
  return facts;
}

}  // namespace cognate::problems
