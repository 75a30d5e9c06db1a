/// @file How the program ends.
#pragma once

namespace cognate::app {

enum ExitStatus : int {
  exit_done = 0,       ///< done; for `solve`: a design meets every constraint
  exit_no_design = 1,  ///< well posed, and no design meets every constraint
  exit_bad_input = 2,  ///< bad options, a bad file, or a place that cannot be written to
  exit_own_fault = 3,  ///< a fault of Cognate's own
};

}  // namespace cognate::app
