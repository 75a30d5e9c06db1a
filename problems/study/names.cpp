#include "problems/study/names.hpp"

namespace cognate::problems {
namespace {

constexpr Named<Sampling> kSamplings[] = {{"sobol", Sampling::sobol},
                                          {"halton", Sampling::halton},
                                          {"latin", Sampling::latin},
                                          {"random", Sampling::random}};
constexpr Named<RunStatus> kRunStatuses[] = {{"solved", RunStatus::solved},
                                             {"infeasible", RunStatus::infeasible},
                                             {"no-solution", RunStatus::no_solution},
                                             {"invalid", RunStatus::invalid},
                                             {"filtered", RunStatus::filtered}};

}  // namespace

template <>
std::span<const Named<Sampling>> names<Sampling>() {
  return kSamplings;
}

template <>
std::span<const Named<RunStatus>> names<RunStatus>() {
  return kRunStatuses;
}

}  // namespace cognate::problems
