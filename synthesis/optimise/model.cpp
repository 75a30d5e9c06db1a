#include "synthesis/optimise/model.hpp"

namespace cognate::synthesis {

void Model::constraints(std::span<const double>, std::span<double>, std::span<double>) const {}

bool Model::lagrangian_hessian(std::span<const double>, std::span<const double>,
                               std::span<const double>, std::span<double>) const {
  return false;
}

}  // namespace cognate::synthesis
