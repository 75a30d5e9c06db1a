#include "problems/mechanism/mechanism_types.hpp"

#include <utility>

namespace cognate::problems {
namespace {

constexpr Vec2d kOrigin{};

std::vector<Body> bodies(std::string first, std::string second, std::string third) {
  return {{"frame"}, {std::move(first)}, {std::move(second)}, {std::move(third)}};
}

Vec2d along_first_axis(double length) {
  return {length, 0};
}

}  // namespace

NamedParts TypeTraits<FourBar>::parts(const FourBar& linkage) {
  NamedParts parts{
      bodies("crank", "coupler", "rocker"),
      {{"A", {{0, linkage.pivot_a}, {1, kOrigin}}},
       {"B", {{1, along_first_axis(linkage.crank)}, {2, kOrigin}}},
       {"C", {{2, along_first_axis(linkage.coupler)}, {3, along_first_axis(linkage.rocker)}}},
       {"D", {{0, linkage.pivot_d}, {3, kOrigin}}}}};
  if (linkage.coupler_point) parts.points.push_back({"P", {{2, *linkage.coupler_point}}});
  return parts;
}

NamedParts TypeTraits<SliderCrank>::parts(const SliderCrank& mechanism) {
  NamedParts parts{bodies("crank", "coupler", "slider"),
                   {{"A", {{0, mechanism.pivot}, {1, kOrigin}}},
                    {"B", {{1, along_first_axis(mechanism.crank)}, {2, kOrigin}}},
                    {"C", {{2, along_first_axis(mechanism.coupler)}, {3, kOrigin}}}}};
  parts.bodies[3].slider = true;
  return parts;
}

NamedParts TypeTraits<GuideBar>::parts(const GuideBar& mechanism) {
  NamedParts parts{bodies("crank", "slider", "guide"),
                   {{"A", {{0, mechanism.pivot_a}, {1, kOrigin}}},
                    {"B", {{1, along_first_axis(mechanism.crank)}, {2, kOrigin}}},
                    {"D", {{0, mechanism.pivot_c}, {3, kOrigin}}}}};
  parts.bodies[2].slider = true;
  return parts;
}

NamedParts TypeTraits<OscillatingBlock>::parts(const OscillatingBlock& mechanism) {
  NamedParts parts{bodies("crank", "block", "rod"),
                   {{"A", {{0, mechanism.pivot_a}, {1, kOrigin}}},
                    {"B", {{1, along_first_axis(mechanism.crank)}, {3, kOrigin}}},
                    {"D", {{0, mechanism.pivot_c}, {2, kOrigin}}}}};
  parts.bodies[2].slider = true;
  return parts;
}

NamedParts TypeTraits<FixedBlock>::parts(const FixedBlock& mechanism) {
  NamedParts parts = TypeTraits<SliderCrank>::parts(as_slider_crank(mechanism));
  parts.bodies[3].name = "rod";
  return parts;
}

NamedParts TypeTraits<ScotchYoke>::parts(const ScotchYoke& mechanism) {
  NamedParts parts{bodies("crank", "block", "yoke"),
                   {{"A", {{0, mechanism.pivot}, {1, kOrigin}}},
                    {"B", {{1, along_first_axis(mechanism.crank)}, {2, kOrigin}}},
                    {"C", {{3, kOrigin}}}}};
  parts.bodies[2].slider = true;
  parts.bodies[3].slider = true;
  return parts;
}

NamedParts TypeTraits<TangentGenerator>::parts(const TangentGenerator& mechanism) {
  NamedParts parts{
      bodies("lever", "block", "slider"),
      {{"A", {{0, mechanism.pivot}, {1, kOrigin}}}, {"B", {{2, kOrigin}, {3, kOrigin}}}}};
  parts.bodies[2].slider = true;
  parts.bodies[3].slider = true;
  return parts;
}

NamedParts TypeTraits<EllipticTrammel>::parts(const EllipticTrammel& mechanism) {
  NamedParts parts{bodies("link", "first-block", "second-block"),
                   {{"A", {{1, kOrigin}, {2, kOrigin}}},
                    {"B", {{1, along_first_axis(mechanism.length)}, {3, kOrigin}}}}};
  parts.bodies[2].slider = true;
  parts.bodies[3].slider = true;
  return parts;
}

NamedParts TypeTraits<OldhamCoupling>::parts(const OldhamCoupling& mechanism) {
  return {bodies("driver", "driven", "disc"),
          {{"A", {{0, mechanism.pivot_a}, {1, kOrigin}}},
           {"D", {{0, mechanism.pivot_d}, {2, kOrigin}}},
           {"C", {{3, kOrigin}}}}};
}

}  // namespace cognate::problems
