// Blocks of mechanisms with changed dimensions, in lanes, compiled once for each instruction set.
#include "analysis/tolerance/sample_kernel.hpp"

#include <cmath>
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
  static Vec2<T> lifted(const Vec2d& v) { return {T(v.x), T(v.y)}; }

  Vec2<T> value_of(const BlockOutput& output) const {
    const auto body = static_cast<std::size_t>(output.body);
    switch (output.of) {
      case BlockOutput::Of::point: {
        const Attached<T>& point = points_[static_cast<std::size_t>(output.point)];
        return place(point.body, point.at);
      }
      case BlockOutput::Of::displacement: {
        const auto& guide = bodies_[static_cast<std::size_t>(output.guide)];
        const Vec2<T> along = guide.direction * lifted(output.along);
        const Vec2<T> from = place(output.guide, lifted(output.through));
        return {dot(bodies_[body].origin[0] - from, along), T(0)};
      }
      case BlockOutput::Of::transmission:
        return {closures_[body].cosine + T(0) * closures_[body].sine,
                sides_[body] * closures_[body].sine};
      default:
        return bodies_[body].direction;
    }
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

/// arcsin s for |s| ≤ 0.1 by its series: what is left out is below 3e-18.
inline double small_arcsine(double s) {
  const double z = s * s;
  return s + s * z *
                 (1.0 / 6 +
                  z * (3.0 / 40 +
                       z * (15.0 / 336 +
                            z * (105.0 / 3456 + z * (945.0 / 42240 + z * (10395.0 / 599040))))));
}

constexpr double kSmallSine = 0.1;

/// The deviations of one station, of an angle.
void angles(const double* x, const double* y, const Vec2d& reference, double* to) {
  double greatest = 0, least_cosine = 1;
  for (std::size_t i = 0; i < kBlockSamples; ++i) {
    const double sine = reference.x * y[i] - reference.y * x[i];
    const double cosine = reference.x * x[i] + reference.y * y[i];
    to[i] = sine;
    const double size = sine < 0 ? -sine : sine;
    greatest = size > greatest ? size : greatest;
    least_cosine = cosine < least_cosine ? cosine : least_cosine;
  }
  if (greatest <= kSmallSine && least_cosine > 0) {
    for (std::size_t i = 0; i < kBlockSamples; ++i) to[i] = small_arcsine(to[i]);
    return;
  }
  for (std::size_t i = 0; i < kBlockSamples; ++i) {
    to[i] = std::atan2(reference.x * y[i] - reference.y * x[i],
                       reference.x * x[i] + reference.y * y[i]);
  }
}

/// Eight sums side by side: so many lanes as the widest instructions have.
constexpr std::size_t kSums = 8;

double total(const double* sums) {
  return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

void errors_of_block(const ErrorTask& task) {
  double deviation[kBlockSamples];
  for (std::size_t s = 0; s < task.stations; ++s) {
    const double* x = task.x + s * kBlockSamples;
    const double* y = task.y + s * kBlockSamples;
    const Vec2d reference = task.reference[s];
    if (task.angular) {
      angles(x, y, reference, deviation);
    } else if (task.normal != nullptr) {
      const Vec2d normal = task.normal[s];
      for (std::size_t i = 0; i < kBlockSamples; ++i) {
        deviation[i] = (x[i] - reference.x) * normal.x + (y[i] - reference.y) * normal.y;
      }
    } else if (task.point) {
      for (std::size_t i = 0; i < kBlockSamples; ++i) {
        const double dx = x[i] - reference.x, dy = y[i] - reference.y;
        deviation[i] = std::sqrt(dx * dx + dy * dy);
      }
    } else {
      for (std::size_t i = 0; i < kBlockSamples; ++i) deviation[i] = x[i] - reference.x;
    }
    double sums[kSums] = {}, squares[kSums] = {};
    const double offset = task.offset[s];
    for (std::size_t i = 0; i < kBlockSamples; i += kSums) {
      for (std::size_t k = 0; k < kSums; ++k) {
        // Not numbers where a sample is not assembled, whose weight is 0.
        const double d = task.weight[i + k] > 0 ? deviation[i + k] : 0;
        sums[k] += d;
        squares[k] += d * d;
        const double error = offset + d;
        const double size = error < 0 ? -error : error;
        double& extreme = task.extreme[i + k];
        extreme = size > extreme ? size : extreme;
      }
    }
    task.sum[s] += total(sums);
    task.square[s] += total(squares);
  }
}

}  // namespace

SampleKernels sample_kernels() {
  return {evaluate_block, errors_of_block};
}

}  // namespace cognate::tolerance::COGNATE_ISA
