// Blocks of mechanisms with changed dimensions, in lanes, compiled once for each instruction set.
#include "analysis/tolerance/sample_kernel.hpp"

#include <cmath>
#include <iterator>
#include <variant>
#include <vector>

#include "analysis/batch/lanes.hpp"
#include "analysis/mechanism/convert.hpp"
#include "analysis/mechanism/kinematics.hpp"

namespace cognate::tolerance::COGNATE_ISA {
namespace {

using T = batch::COGNATE_ISA::Lanes<double>;

/// Mechanisms of one pack of samples.
class Pack {
 public:
  Pack(const BlockTask& task, std::size_t at) : task_(task) {
    std::size_t next = 0;
    auto lift = [&task, &next, at](double number) {
      T value(number);
      for (std::size_t k = task.begin[next]; k < task.begin[next + 1]; ++k) {
        value = value +
                T(task.factor[k]) * T::load(task.changes + task.dimension[k] * kBlockSamples + at);
      }
      ++next;
      return value;
    };
    Converter<T, decltype(lift)> converter(lift);
    mechanism_.drive = converter(*task.drive);
    mechanism_.dyads.reserve(task.dyad_count);
    for (std::size_t i = 0; i < task.dyad_count; ++i) {
      mechanism_.dyads.push_back(converter(task.dyads[i]));
    }
    for (std::size_t i = 0; i < task.point_count; ++i) {
      const T u = lift(task.points[i].at.x);
      const T v = lift(task.points[i].at.y);
      points_.push_back({task.points[i].body, {u, v}});
    }
    bodies_.resize(static_cast<std::size_t>(body_count(mechanism_)));
    closures_.resize(task.dyad_count);
    sides_.resize(task.dyad_count, T(0));
  }

  /// As a FourBarTask has it.
  void four_bar(const FourBarTask& to, std::size_t at) const {
    const auto& crank = std::get<Crank<T>>(mechanism_.drive);
    const auto& dyad = std::get<Rrr<T>>(mechanism_.dyads.front());
    const T own[] = {crank.pivot.x,   crank.pivot.y,     dyad.second.at.x,  dyad.second.at.y,
                     dyad.first.at.x, dyad.first_length, dyad.second_length};
    for (std::size_t i = 0; i < std::size(own); ++i) own[i].store(to.own + i * kBlockSamples + at);
    for (std::size_t p = 0; p < to.points; ++p) {
      const bool is_point = to.outputs[p].of == BlockOutput::Of::point;
      const Vec2<T> place = is_point ? points_[static_cast<std::size_t>(to.outputs[p].point)].at
                                     : Vec2<T>{dyad.first_length, T(0)};
      place.x.store(to.u + p * kBlockSamples + at);
      place.y.store(to.v + p * kBlockSamples + at);
    }
  }

  void station(std::size_t s, std::size_t at) {
    for (std::size_t i = 0; i < task_.dyad_count; ++i) {
      sides_[i] = T(task_.sides[s * task_.dyad_count + i]);
    }
    const DrivePosition<T> drive{{T(task_.cos[s]), T(task_.sin[s])}, T(task_.displacement[s])};
    evaluate<0>(mechanism_, drive, std::span<const T>(sides_), std::span<BodyMotion<T, 0>>(bodies_),
                std::span<DyadClosure<T>>(closures_));
    for (std::size_t i = 0; i < task_.output_count; ++i) {
      const BlockOutput& output = task_.outputs[i];
      const Vec2<T> value = value_of(output);
      value.x.store(output.x + s * kBlockSamples + at);
      value.y.store(output.y + s * kBlockSamples + at);
    }
  }

 private:
  Vec2<T> place(int body, const Vec2<T>& at) const {
    const auto& motion = bodies_[static_cast<std::size_t>(body)];
    return motion.origin[0] + motion.direction * at;
  }
  Vec2<T> point(int index) const {
    const Attached<T>& point = points_[static_cast<std::size_t>(index)];
    return place(point.body, point.at);
  }
  static Vec2<T> lifted(const Vec2d& v) { return {T(v.x), T(v.y)}; }

  Vec2<T> value_of(const BlockOutput& output) const {
    const auto body = static_cast<std::size_t>(output.body);
    switch (output.of) {
      case BlockOutput::Of::point:
        return point(output.point);
      case BlockOutput::Of::direction: {
        const Vec2<T> way = point(output.to) - point(output.point);
        const T inverse = T(1) / sqrt(squared_norm(way));
        return {way.x * inverse, way.y * inverse};
      }
      case BlockOutput::Of::displacement: {
        const auto& guide = bodies_[static_cast<std::size_t>(output.guide)];
        const Vec2<T> along = guide.direction * lifted(output.along);
        const Vec2<T> from = place(output.guide, lifted(output.through));
        return {dot(bodies_[body].origin[0] - from, along), T(0)};
      }
      case BlockOutput::Of::along:
        return {dot(point(output.point), lifted(output.along)), T(0)};
      case BlockOutput::Of::transmission:
        return {closures_[body].cosine + T(0) * closures_[body].sine,
                sides_[body] * closures_[body].sine};
      case BlockOutput::Of::angle:
        break;
    }
    return bodies_[body].direction;
  }

  const BlockTask& task_;
  Mechanism<T> mechanism_;
  std::vector<Attached<T>> points_;
  std::vector<T> sides_;
  std::vector<BodyMotion<T, 0>> bodies_;
  std::vector<DyadClosure<T>> closures_;
};

void evaluate_block(const BlockTask& task) {
  for (std::size_t at = 0; at < kBlockSamples; at += T::kSize) {
    Pack pack(task, at);
    for (std::size_t s = 0; s < task.stations; ++s) pack.station(s, at);
  }
}

void four_bars(const FourBarTask& task) {
  for (std::size_t at = 0; at < kBlockSamples; at += T::kSize) {
    Pack(*task.mechanism, at).four_bar(task, at);
  }
}

void directions(const FourBarTask& task, std::size_t stations) {
  for (std::size_t p = 0; p < task.points; ++p) {
    const BlockOutput& output = task.outputs[p];
    if (output.of != BlockOutput::Of::angle) continue;
    for (std::size_t at = 0; at < kBlockSamples; at += T::kSize) {
      const auto own = [&](std::size_t i) { return T::load(task.own + i * kBlockSamples + at); };
      const T x = own(2), y = own(3), inverse = T(1) / own(6);
      for (std::size_t s = 0; s < stations; ++s) {
        double *to_x = output.x + s * kBlockSamples + at, *to_y = output.y + s * kBlockSamples + at;
        ((T::load(to_x) - x) * inverse).store(to_x);
        ((T::load(to_y) - y) * inverse).store(to_y);
      }
    }
  }
}

/// arcsin s for |s| ≤ 0.1 by its series: what is left out is below 3e-18.
T small_arcsine(const T& s) {
  const T z = s * s;
  T series(10395.0 / 599040);
  for (const double factor : {945.0 / 42240, 105.0 / 3456, 15.0 / 336, 3.0 / 40, 1.0 / 6}) {
    series = T(factor) + z * series;
  }
  return s + s * z * series;
}

constexpr double kSmallSine = 0.1;

/// One station of an ErrorTask: `deviations` fills its deviations, 0 of samples of no weight.
class StationErrors {
 public:
  StationErrors(const ErrorTask& task, std::size_t s)
      : task_(task),
        x_(task.x + s * kBlockSamples),
        y_(task.y + s * kBlockSamples),
        s_(s),
        reference_(task.reference[s]) {}

  void deviations(double* to) const {
    if (task_.angular) {
      angles(to);
    } else if (task_.normal != nullptr) {
      const T nx(task_.normal[s_].x), ny(task_.normal[s_].y);
      each(to, [&](const T& dx, const T& dy) { return dx * nx + dy * ny; });
    } else if (task_.point) {
      each(to, [](const T& dx, const T& dy) { return sqrt(dx * dx + dy * dy); });
    } else {
      each(to, [](const T& dx, const T& /*none*/) { return dx; });
    }
  }

 private:
  /// `x`, but `other` where it is not a number, the sample not being assembled.
  T weighed(const T& x, double other, std::size_t at) const {
    return replace_zero(x, T::load(task_.weight + at), T(other));
  }

  template <class Deviation>
  void each(double* to, const Deviation& deviation) const {
    const T x(reference_.x), y(reference_.y);
    for (std::size_t at = 0; at < kBlockSamples; at += T::kSize) {
      const T d = deviation(T::load(x_ + at) - x, T::load(y_ + at) - y);
      weighed(d, 0, at).store(to + at);
    }
  }

  void angles(double* to) const {
    const T x(reference_.x), y(reference_.y);
    T greatest(0), least_cosine(1);
    for (std::size_t at = 0; at < kBlockSamples; at += T::kSize) {
      const T own_x = T::load(x_ + at), own_y = T::load(y_ + at);
      const T sine = weighed(x * own_y - y * own_x, 0, at);
      greatest = max(greatest, abs(sine));
      least_cosine = min(least_cosine, weighed(x * own_x + y * own_y, 1, at));
      small_arcsine(sine).store(to + at);
    }
    double greatest_of[T::kSize], least_of[T::kSize];
    greatest.store(greatest_of);
    least_cosine.store(least_of);
    bool small = true;
    for (std::size_t i = 0; i < T::kSize; ++i) {
      small = small && greatest_of[i] <= kSmallSine && least_of[i] > 0;
    }
    if (!small) large_angles(to);
  }

  void large_angles(double* to) const {
    for (std::size_t i = 0; i < kBlockSamples; ++i) {
      to[i] = task_.weight[i] > 0 ? std::atan2(reference_.x * y_[i] - reference_.y * x_[i],
                                               reference_.x * x_[i] + reference_.y * y_[i])
                                  : 0;
    }
  }

  const ErrorTask& task_;
  const double *x_, *y_;
  std::size_t s_;
  Vec2d reference_;
};

/// Eight sums side by side: so many lanes as the widest instructions have.
constexpr std::size_t kSums = 8;

double total(const T* packs) {
  double sums[kSums];
  for (std::size_t k = 0; k < kSums / T::kSize; ++k) packs[k].store(sums + k * T::kSize);
  return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

void errors_of_block(const ErrorTask& task) {
  double deviation[kBlockSamples];
  for (std::size_t s = 0; s < task.stations; ++s) {
    StationErrors(task, s).deviations(deviation);
    T sums[kSums / T::kSize], squares[kSums / T::kSize];
    for (T& sum : sums) sum = T(0);
    for (T& square : squares) square = T(0);
    const T offset(task.offset[s]);
    for (std::size_t i = 0; i < kBlockSamples; i += kSums) {
      for (std::size_t k = 0; k < kSums / T::kSize; ++k) {
        const std::size_t at = i + k * T::kSize;
        const T d = T::load(deviation + at);
        sums[k] = sums[k] + d;
        squares[k] = squares[k] + d * d;
        max(T::load(task.extreme + at), abs(offset + d)).store(task.extreme + at);
      }
    }
    task.sum[s] += total(sums);
    task.square[s] += total(squares);
  }
}

}  // namespace

SampleKernels sample_kernels() {
  return {evaluate_block, four_bars, directions, errors_of_block};
}

}  // namespace cognate::tolerance::COGNATE_ISA
