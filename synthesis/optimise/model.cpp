#include "synthesis/optimise/model.hpp"

namespace cognate::synthesis {

void Model::constraints(std::span<const double>, std::span<double>, std::span<double>) const {}

}  // namespace cognate::synthesis
