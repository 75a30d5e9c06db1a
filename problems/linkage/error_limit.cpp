#include "problems/linkage/error_limit.hpp"

#include <string_view>

#include "problems/basics/degrees.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
double shown_error(ErrorMeasure of, double error) {
  return is_angle(of) ? degrees(error) : error;
}

std::string error_column(ErrorMeasure of) {
  std::string_view key = to_string(of);
  key.remove_suffix(std::string_view("_max").size());
  return std::string(key);
}

void check_error(const ErrorLimit& limit, double error, Design& design) {
  design.constraints.push_back({std::string(to_string(limit.of)), shown_error(limit.of, error),
                                shown_error(limit.of, limit.max),
                                error <= limit.max * (1 + kCheckTolerance)});
}

}  // namespace cognate::problems
