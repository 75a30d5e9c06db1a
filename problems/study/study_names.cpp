#include "problems/study/study_names.hpp"

namespace cognate::problems {
namespace {

constexpr Named<Sampling> kSamplings[] = {{"sobol", Sampling::sobol},
                                          {"halton", Sampling::halton},
                                          {"latin", Sampling::latin},
                                          {"random", Sampling::random}};

}  // namespace

template <>
std::span<const Named<Sampling>> names<Sampling>() {
  return kSamplings;
}

}  // namespace cognate::problems
