// Compiled once for each instruction set.
#include "analysis/batch/roots.hpp"
#include "batch_roots.hpp"

namespace cognate::batch::COGNATE_ISA {
namespace {

template <class Real>
void find(const RootsTask<Real>& task) {
  using T = Lanes<Real>;
  for (std::size_t i = 0; i < task.count; i += T::kSize) {
    const T x = T::load(task.x + i);
    const Roots<T> found = roots<true>(x, x);
    found.root.store(task.root + i);
    found.inverse.store(task.inverse + i);
    found.inverse_root.store(task.inverse_root + i);
  }
}

}  // namespace

void find_roots(const RootsTask<double>& task) {
  find(task);
}

void find_roots(const RootsTask<float>& task) {
  find(task);
}

}  // namespace cognate::batch::COGNATE_ISA
