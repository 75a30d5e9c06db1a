#include "problems/cam/toleranced_length.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "problems/basics/names.hpp"

namespace cognate::problems {

tl::expected<std::optional<TolerancedDimension>, ImpossibleTolerance> toleranced_length(
    const CamProblem& problem, CamDimension dimension, double nominal) {
  if (!problem.tolerances || !problem.has_tolerance(dimension)) return std::nullopt;
  const Tolerances& tolerances = *problem.tolerances;
  const std::string name(to_string(dimension));
  const auto named = std::ranges::find(tolerances.dimensions, name, &NamedTolerance::dimension);
  const bool is_named = named != tolerances.dimensions.end();
  if (!is_named && !tolerances.length) return std::nullopt;
  const auto deviation = deviation_of(name, nominal, is_named ? named->value : *tolerances.length,
                                      problem.length_unit);
  if (!deviation) return tl::unexpected(ImpossibleTolerance{name, deviation.error()});
  if (deviation->plus == 0 && deviation->minus == 0) return std::nullopt;
  const bool is_length =
      dimension != CamDimension::offset && dimension != CamDimension::face_offset;
  TolerancedDimension made{name, nominal, *deviation, is_length};
  if (auto reason = nothing_left(made)) {
    return tl::unexpected(ImpossibleTolerance{name, *std::move(reason)});
  }
  return made;
}

}  // namespace cognate::problems
