#include "problems/leg/problem.hpp"

namespace cognate::problems {
namespace {

constexpr Named<LegObjective> kLegObjectives[] = {{"flatness", LegObjective::flatness},
                                                  {"duty", LegObjective::duty}};

}  // namespace

template <>
std::span<const Named<LegObjective>> names<LegObjective>() {
  return kLegObjectives;
}

}  // namespace cognate::problems
