#include "problems/tolerance/tolerances.hpp"

namespace cognate::problems {
namespace {

constexpr Named<ToleranceDistribution> kDistributions[] = {
    {"normal", ToleranceDistribution::normal}, {"uniform", ToleranceDistribution::uniform}};
constexpr Named<AllocationBasis> kBases[] = {{"worst-case", AllocationBasis::worst_case},
                                             {"rss", AllocationBasis::rss}};

}  // namespace

template <>
std::span<const Named<ToleranceDistribution>> names<ToleranceDistribution>() {
  return kDistributions;
}
template <>
std::span<const Named<AllocationBasis>> names<AllocationBasis>() {
  return kBases;
}

}  // namespace cognate::problems
