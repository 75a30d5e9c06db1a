#include "app/console/design_dimensions.hpp"

#include <cmath>
#include <variant>

namespace cognate::app {
namespace {

using List = std::vector<Dimension>;

double distance(const Vec2d& from, const Vec2d& to) {
  return std::hypot(to.x - from.x, to.y - from.y);
}

template <class SliderCrankLike>
List slider_crank(const SliderCrankLike& mechanism) {
  return {{"crank", mechanism.crank}, {"coupler", mechanism.coupler}, {"offset", mechanism.offset}};
}

template <class GuideBarLike>
List guide_bar(const GuideBarLike& mechanism) {
  return {{"crank", mechanism.crank},
          {"frame", distance(mechanism.pivot_a, mechanism.pivot_c)},
          {"offset", mechanism.offset}};
}

struct Dimensions {
  List operator()(const FourBar& linkage) const {
    return {{"crank", linkage.crank},
            {"coupler", linkage.coupler},
            {"rocker", linkage.rocker},
            {"frame", distance(linkage.pivot_a, linkage.pivot_d)}};
  }
  List operator()(const SliderCrank& mechanism) const { return slider_crank(mechanism); }
  List operator()(const FixedBlock& mechanism) const { return slider_crank(mechanism); }
  List operator()(const GuideBar& mechanism) const { return guide_bar(mechanism); }
  List operator()(const OscillatingBlock& mechanism) const { return guide_bar(mechanism); }
  List operator()(const ScotchYoke& mechanism) const {
    return {{"crank", mechanism.crank}, {"offset", mechanism.offset}};
  }
  List operator()(const TangentGenerator& mechanism) const {
    return {{"offset", mechanism.offset}};
  }
  List operator()(const EllipticTrammel& mechanism) const { return {{"length", mechanism.length}}; }
  List operator()(const OldhamCoupling& mechanism) const {
    return {{"frame", distance(mechanism.pivot_a, mechanism.pivot_d)}};
  }
  List operator()(const problems::ChainDescription& chain) const {
    List list;
    if (const auto* crank = std::get_if<problems::CrankDescription>(&chain.drive)) {
      list.push_back({crank->name, crank->length});
    }
    for (const auto& dyad : chain.dyads) {
      for (std::size_t i = 0; i < dyad.lengths.size(); ++i) {
        list.push_back({dyad.names[i], dyad.lengths[i]});
      }
    }
    if (chain.pivots.size() == 2) {
      list.push_back({"frame", distance(chain.pivots[0].at, chain.pivots[1].at)});
    }
    return list;
  }
};

}  // namespace

std::vector<Dimension> dimensions(const problems::NamedMechanism& mechanism) {
  List list = std::visit(Dimensions{}, mechanism.description);
  if (mechanism.type != problems::MechanismType::chain) return list;
  for (const auto& point : mechanism.extra_points) {
    list.push_back({point.on.front(), std::hypot(point.at.x, point.at.y)});
  }
  return list;
}

}  // namespace cognate::app
