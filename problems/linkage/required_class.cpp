#include "problems/linkage/required_class.hpp"

namespace cognate::problems {

bool is_of_class(MobilityClass found, RequiredClass required) {
  switch (required) {
    case RequiredClass::crank_rocker:
      return found == MobilityClass::crank_rocker;
    case RequiredClass::double_crank:
      return found == MobilityClass::double_crank;
    case RequiredClass::rocker_crank:
      return found == MobilityClass::rocker_crank;
    case RequiredClass::double_rocker:
      return found == MobilityClass::double_rocker;
    case RequiredClass::grashof:
      return found != MobilityClass::triple_rocker;
    case RequiredClass::triple_rocker:
    case RequiredClass::non_grashof:
      return found == MobilityClass::triple_rocker;
  }
  return false;
}

}  // namespace cognate::problems
