/// @file When a run has to end before it is done.
#pragma once

#include "synthesis/search/deadline.hpp"

namespace cognate::problems {

struct Run;

/// The user's interrupt or the end of a run's time.
class Deadline : public synthesis::Deadline {
 public:
  explicit Deadline(const Run& run);
};

}  // namespace cognate::problems
