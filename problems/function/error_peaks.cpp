#include "problems/function/error_peaks.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/golden_section.hpp"

namespace cognate::problems {
namespace {

using synthesis::AnglePair;

constexpr int kHalvings = 30;
constexpr int kGoldenSteps = 30;

/// A place of the domain, by its share, and |error| there.
struct Probe {
  double share = 0;
  AnglePair pair;
  double size = 0;
};

class Probes {
 public:
  Probes(const std::function<double(const AnglePair&)>& error, const FunctionSamples& wanted)
      : error_(error), wanted_(wanted) {
    for (std::size_t i = 0; i < wanted.range.size(); ++i) {
      const double share = static_cast<double>(i) / kRangeSteps;
      add(share, wanted.range[i]);
    }
    for (const auto& [share, pair] : wanted.between) add(share, pair);
  }

  /// Places on both sides of an input, ever nearer to it, and itself.
  void add_about(double input) {
    const double first = wanted_.range.front().input, last = wanted_.range.back().input;
    const double middle = std::clamp((input - first) / (last - first), 0.0, 1.0);
    add(middle);
    double step = 1.0 / kRangeSteps;
    for (int i = 0; i < kHalvings; ++i, step *= 0.5) {
      if (middle - step >= 0) add(middle - step);
      if (middle + step <= 1) add(middle + step);
    }
  }

  std::vector<AnglePair> peaks() {
    std::ranges::stable_sort(all_, {}, &Probe::share);
    const double least = 0.5 * std::ranges::max(all_, {}, &Probe::size).size;
    std::vector<AnglePair> result;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const bool first = i == 0, last = i + 1 == all_.size();
      if (all_[i].size < least || (!first && all_[i].size < all_[i - 1].size) ||
          (!last && all_[i].size < all_[i + 1].size)) {
        continue;
      }
      result.push_back(first || last ? all_[i].pair : refined(i));
    }
    return result;
  }

 private:
  void add(double share, const AnglePair& pair) {
    all_.push_back({share, pair, std::abs(error_(pair))});
  }
  void add(double share) { add(share, wanted_.at(share)); }

  /// The highest place between the neighbours of a probe, taken to have one peak between them.
  AnglePair refined(std::size_t i) const {
    const auto lowered = [&](double share) { return -std::abs(error_(wanted_.at(share))); };
    const double share =
        golden_section(lowered, all_[i - 1].share, all_[i + 1].share, kGoldenSteps).middle();
    const AnglePair pair = wanted_.at(share);
    return std::abs(error_(pair)) > all_[i].size ? pair : all_[i].pair;
  }

  const std::function<double(const AnglePair&)>& error_;
  const FunctionSamples& wanted_;
  std::vector<Probe> all_;
};

}  // namespace

std::vector<AnglePair> error_peaks(const std::function<double(const AnglePair&)>& error,
                                   const FunctionSamples& wanted,
                                   std::span<const double> critical) {
  if (wanted.range.empty()) return {};
  Probes probes(error, wanted);
  for (const double input : critical) probes.add_about(input);
  return probes.peaks();
}

}  // namespace cognate::problems
