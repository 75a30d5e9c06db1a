/// @file Problems that no solver is given.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// What solving a problem with such faults gives; `AnyResult` has a status and notes.
template <class AnyResult>
AnyResult refused(std::vector<std::string> faults) {
  AnyResult result;
  result.status = Status::invalid;
  result.notes = std::move(faults);
  return result;
}

}  // namespace cognate::problems
