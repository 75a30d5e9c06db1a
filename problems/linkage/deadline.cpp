#include "problems/linkage/deadline.hpp"

#include <limits>

#include "problems/linkage/result.hpp"

namespace cognate::problems {

Deadline::Deadline(const Run& run)
    : limit_(run.time_limit.value_or(std::numeric_limits<double>::infinity())),
      interrupted_(run.interrupted) {}

bool Deadline::interrupted() const {
  return interrupted_ && interrupted_->load();
}

double Deadline::spent() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

double Deadline::remaining() const {
  return limit_ - spent();
}

}  // namespace cognate::problems
