// A chain of dyads at packs of drive positions, compiled once for each instruction set.
#include "analysis/batch/chain_kernel.hpp"

#include <vector>

#include "analysis/batch/lanes.hpp"
#include "analysis/mechanism/convert.hpp"
#include "analysis/mechanism/kinematics.hpp"

namespace cognate::batch::COGNATE_ISA {
namespace {

using T = Lanes<double>;

void store(const T& value, double* to, std::size_t row) {
  if (to != nullptr) value.store(to + row);
}

/// The mechanism with the same numbers in all lanes.
Mechanism<T> in_lanes(const ChainTask& task) {
  auto lift = [](double x) { return T(x); };
  Converter<T, decltype(lift)> converter(lift);
  Mechanism<T> mechanism;
  mechanism.drive = converter(*task.drive);
  mechanism.dyads.reserve(task.dyad_count);
  for (std::size_t i = 0; i < task.dyad_count; ++i) {
    mechanism.dyads.push_back(converter(task.dyads[i]));
  }
  return mechanism;
}

/// A chain's state in lanes, and the writing of it.
template <int Order>
class ChainLanes {
 public:
  explicit ChainLanes(const ChainTask& task)
      : task_(task),
        mechanism_(in_lanes(task)),
        bodies_(static_cast<std::size_t>(body_count(mechanism_))),
        closures_(task.dyad_count) {
    sides_.reserve(task.dyad_count);
    for (std::size_t i = 0; i < task.dyad_count; ++i) sides_.push_back(T(task.sides[i]));
  }

  void row(std::size_t at) {
    const DrivePosition<T> drive{{T::load(task_.cos + at), T::load(task_.sin + at)},
                                 T::load(task_.displacement + at)};
    evaluate<Order>(mechanism_, drive, sides_, bodies_, closures_);
    for (std::size_t i = 0; i < task_.output_count; ++i) write(task_.outputs[i], at);
  }

 private:
  void write(const ChainOutput& output, std::size_t at) const {
    const auto index = static_cast<std::size_t>(output.index);
    if (output.of == ChainOutput::Of::point) {
      const auto motion = point_motion(bodies_[index], Vec2<T>{T(output.at.x), T(output.at.y)});
      for (std::size_t k = 0; k <= Order; ++k) {
        store(motion[k].x, output.first[k], at);
        store(motion[k].y, output.second[k], at);
      }
    } else if (output.of == ChainOutput::Of::body) {
      store(bodies_[index].direction.x, output.first[0], at);
      store(bodies_[index].direction.y, output.second[0], at);
      for (std::size_t k = 1; k <= Order; ++k) {
        store(bodies_[index].turn[k - 1], output.first[k], at);
      }
    } else {
      store(closures_[index].sine, output.first[0], at);
      // 0·sine makes the cosine, too, no number where the dyad cannot be assembled.
      store(closures_[index].cosine + T(0) * closures_[index].sine, output.second[0], at);
    }
  }

  const ChainTask task_;
  Mechanism<T> mechanism_;
  std::vector<T> sides_;
  std::vector<BodyMotion<T, Order>> bodies_;
  std::vector<DyadClosure<T>> closures_;
};

template <int Order>
void chain(const ChainTask& task) {
  ChainLanes<Order> lanes(task);
  for (std::size_t start = task.begin; start < task.end; start += T::kSize) {
    // The last pack ends with the last row, and does some rows again.
    lanes.row(start + T::kSize <= task.end ? start : task.end - T::kSize);
  }
}

}  // namespace

ChainKernels chain_kernels() {
  return {T::kSize, {chain<0>, chain<1>, chain<2>, chain<3>}};
}

}  // namespace cognate::batch::COGNATE_ISA
