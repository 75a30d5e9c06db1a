/// @file A mechanism as a function of its dimensions.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "analysis/mechanism/convert.hpp"
#include "analysis/mechanism/mechanism.hpp"

namespace cognate {

/// A mechanism over T with points of its bodies.
template <class T>
struct MechanismWithPoints {
  Mechanism<T> mechanism;
  std::vector<Attached<T>> points;
};

/// Every number of a mechanism and of its points is its nominal value plus a sum of the changes of
/// dimensions by fixed factors: lengths, offsets and coordinates are such numbers themselves, and
/// the pivot at the end of a frame moves along its line. So any number type of the kernel takes
/// part in the changes.
class AffineMechanism {
 public:
  AffineMechanism() = default;

  /// `slopes[i]`: how much each number of `numbers(nominal)` grows with dimension i.
  AffineMechanism(MechanismWithPoints<double> nominal,
                  const std::vector<std::vector<double>>& slopes);

  /// All numbers in the order in which they are carried over: those of the mechanism as
  /// `Converter` has it, then the points' places.
  static std::vector<double> numbers(const MechanismWithPoints<double>& nominal);

  const MechanismWithPoints<double>& nominal() const { return nominal_; }
  std::size_t dimension_count() const { return dimensions_; }

  /// Which dimensions change number i, by what factors: terms [begin[i], begin[i + 1]).
  struct Terms {
    const std::size_t *begin, *dimension;
    const double* factor;
  };
  Terms terms() const { return {begin_.data(), dimension_.data(), factor_.data()}; }

  /// With `changes` of its dimensions, one for each.
  template <class T>
  MechanismWithPoints<T> at(std::span<const T> changes) const {
    std::size_t next = 0;
    const auto lift = [&](double number) {
      T value(number);
      for (std::size_t k = begin_[next]; k < begin_[next + 1]; ++k) {
        const T& change = changes[dimension_[k]];
        value = factor_[k] == 1 ? T(value + change) : T(value + T(factor_[k]) * change);
      }
      ++next;
      return value;
    };
    MechanismWithPoints<T> changed;
    changed.mechanism = convert<T>(nominal_.mechanism, lift);
    changed.points.reserve(nominal_.points.size());
    for (const Attached<double>& point : nominal_.points) {
      const T x = lift(point.at.x);
      const T y = lift(point.at.y);
      changed.points.push_back({point.body, {x, y}});
    }
    return changed;
  }

 private:
  MechanismWithPoints<double> nominal_;
  std::size_t dimensions_ = 0;
  std::vector<std::size_t> begin_{0};  ///< of each number's terms; one more than numbers
  std::vector<std::size_t> dimension_;
  std::vector<double> factor_;
};

}  // namespace cognate
