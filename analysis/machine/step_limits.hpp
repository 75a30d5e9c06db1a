/// @file How long steps may be that jump over nothing, by samples of what is integrated.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace cognate::machine {

/// The longest steps over an interval: short where sampled values bend sharply, and growing with
/// the distance from there, so that no step comes far into such a stretch from outside. What is
/// narrower than a sample's cell may be missed.
class StepLimits {
 public:
  /// `samples` equal cells from `from` on, each with its sample in the middle.
  StepLimits(double from, double length, std::size_t samples);

  std::size_t samples() const { return longest_.size(); }
  double place(std::size_t sample) const {
    return from_ + (static_cast<double>(sample) + 0.5) * cell_;
  }

  /// Shortens steps where `values`, one for each sample, bend by more than a small part of `size`.
  /// Only samples of the same stretch (numbered, in order) are compared: between two there is a
  /// jump that no step crosses.
  void shorten(std::span<const double> values, std::span<const int> stretches, double size);

  /// Shortens all to `longest`.
  void shorten(double longest);

  /// The longest step from `x`, forwards or backwards.
  double at(double x) const;

 private:
  void grade();

  double from_, cell_;
  std::vector<double> longest_;
};

}  // namespace cognate::machine
