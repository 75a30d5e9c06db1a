#include "problems/chain/raster/descent.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "analysis/numbers/parallel.hpp"

namespace cognate::problems {
namespace {

using synthesis::RasterNumbers;

constexpr std::size_t kKnown = 32;  ///< combinations that are handed on

struct Reached {
  RasterNumbers at;
  PlacedChain chain;
};

class RasterDescent {
 public:
  RasterDescent(const ScaledChain& scaled, const ChainAxes& axes) : scaled_(scaled), axes_(axes) {}

  Reached descend(const PlacedChain& start, const Deadline& deadline) const {
    Reached here{rounded(start), start};
    here.chain = fitted(here.at, start);
    while (!deadline.reached() && (is_improved(here, false) || is_improved(here, true))) {
    }
    return here;
  }

 private:
  RasterNumbers rounded(const PlacedChain& chain) const {
    RasterNumbers at;
    for (std::size_t i = 0; i < axes_.axes.size(); ++i) {
      const auto& [parameter, origin, size] = axes_.places[i];
      at.push_back(
          axes_.axes[i].values.nearest(origin + size * chain.design.parameters[parameter]));
    }
    return at;
  }

  PlacedChain fitted(const RasterNumbers& at, PlacedChain from) const {
    set_numbers(axes_, at, from.design);
    fit_place(scaled_, from);
    return from;
  }

  bool move(RasterNumbers& at, std::size_t axis, int by) const {
    at[axis] += by;
    return at[axis] >= 0 && at[axis] < axes_.axes[axis].values.count();
  }

  /// To the best neighbour if that is better; `pairs`: of those that differ in two dimensions.
  bool is_improved(Reached& here, bool pairs) const {
    Reached best = here;
    const auto look = [&](const RasterNumbers& at) {
      PlacedChain chain = fitted(at, here.chain);
      if (chain.objective < best.chain.objective) best = {at, std::move(chain)};
    };
    for (std::size_t i = 0; i < axes_.axes.size(); ++i) {
      for (const int by : {-1, 1}) {
        RasterNumbers one = here.at;
        if (!move(one, i, by)) continue;
        if (!pairs) look(one);
        for (std::size_t k = i + 1; pairs && k < axes_.axes.size(); ++k) {
          for (const int other : {-1, 1}) {
            RasterNumbers two = one;
            if (move(two, k, other)) look(two);
          }
        }
      }
    }
    const bool is_better = best.chain.objective < here.chain.objective;
    if (is_better) here = std::move(best);
    return is_better;
  }

  const ScaledChain& scaled_;
  const ChainAxes& axes_;
};

}  // namespace

void set_numbers(const ChainAxes& axes, const synthesis::RasterNumbers& at,
                 synthesis::ChainDesign& design) {
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto& [parameter, origin, size] = axes.places[i];
    design.parameters[parameter] = (axes.axes[i].values.at(at[i]) - origin) / size;
  }
}

std::vector<PlacedChain> descend_on_raster(const ScaledChain& scaled, const ChainAxes& axes,
                                           std::span<const PlacedChain> starts, int threads,
                                           const Deadline& deadline) {
  const RasterDescent descent(scaled, axes);
  std::vector<Reached> reached(starts.size());
  parallel_for(static_cast<int>(starts.size()), threads, [&](int index, int) {
    const auto i = static_cast<std::size_t>(index);
    reached[i] = descent.descend(starts[i], deadline);
  });
  std::map<RasterNumbers, PlacedChain> different;
  for (Reached& one : reached) {
    if (std::isfinite(one.chain.objective)) different.emplace(one.at, std::move(one.chain));
  }
  std::vector<PlacedChain> best;
  for (auto& [at, chain] : different) best.push_back(std::move(chain));
  std::ranges::stable_sort(best, {}, &PlacedChain::objective);
  if (best.size() > kKnown) best.resize(kKnown);
  return best;
}

}  // namespace cognate::problems
