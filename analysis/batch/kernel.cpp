// The loops of a batch, compiled once for each instruction set: COGNATE_ISA names it and
// COGNATE_ARCH is xsimd's architecture (undefined for scalar).
#include "analysis/batch/kernel.hpp"

#include <utility>

#include "analysis/batch/evaluate.hpp"

namespace cognate::batch::COGNATE_ISA {
namespace {

/// Columns that an instance computes but that were not requested are null: none if it has only one.
template <unsigned kSet, class Real>
struct Writer {
  static constexpr bool kAllWanted = kSet == position || kSet == transmission;
  Real* const (&columns)[kColumns];
  std::size_t at;        ///< in columns of coupler points
  std::size_t at_links;  ///< in columns that all points share

  template <class T>
  void operator()(std::size_t column, const T& value) const {
    if (!kAllWanted && columns[column] == nullptr) return;
    const bool shared = column == column_transmission_sin || column == column_transmission_cos;
    value.store(columns[column] + (shared ? at_links : at));
  }
};

template <unsigned kSet>
constexpr std::bool_constant<has(kSet, velocity | acceleration | curvature | gradient)>
    needs_inverse_root{};

// The loops are flattened: all that they call becomes part of them, so that the constants of a
// design stay in registers.

template <unsigned kSet, class Real, class T>
void design_over_run(const OneDesignTask<Real>& task, const Design<T>& design, const Vec2<T>& point,
                     const Run& run) {
  const HalfDesign<T> half(design, run.side);
  const T half_assembly = T(0.5) * design.assembly;
  const PointOnly<T> point_only(design, half, point);
  const Transmission<T> transmission_of(design);
  for (std::size_t start = run.begin; start < run.end; start += T::kSize) {
    // The last pack ends with the last row, and does some rows again.
    const std::size_t row = start + T::kSize <= run.end ? start : run.end - T::kSize;
    const T sin = T::load(task.sin + row), versine = T::load(task.versine + row);
    const Writer<kSet, Real> write{task.columns, row, row};
    const Triangle<T> at(half.closure, versine, half_assembly, needs_inverse_root<kSet>);
    if constexpr (has(kSet, transmission)) transmission_of(at, write);
    if constexpr ((kSet & ~unsigned{transmission}) == position) {
      point_only(sin, versine, at, write);
    } else if constexpr (kSet != transmission) {
      write_point<kSet>(design, LinkMotion<kSet, T>(design, half, sin, versine, at), point, write);
    }
  }
}

template <unsigned kSet, class Real>
[[gnu::flatten]] void one_design(const OneDesignTask<Real>& given) {
  using T = Lanes<Real>;
  const OneDesignTask<Real> task = given;  // which no column can overlap
  const Design<T> design(*task.design);
  const Vec2<T> point{T(task.point.x), T(task.point.y)};
  for (std::size_t run = 0; run < task.run_count; ++run) {
    design_over_run<kSet>(task, design, point, task.runs[run]);
  }
}

template <class Real>
auto load_design(const ManyDesignsTask<Real>& task, std::size_t first) {
  using T = Lanes<Real>;
  const auto load = [first](const Real* from) { return T::load(from + first); };
  return Design<T>(Dimensions<T>{{load(task.pivot_a_x), load(task.pivot_a_y)},
                                 {load(task.pivot_d_x), load(task.pivot_d_y)},
                                 load(task.crank),
                                 load(task.coupler),
                                 load(task.rocker),
                                 load(task.assembly)});
}

/// The designs from `first` on, as many as there are lanes, over one run of the table.
template <unsigned kSet, bool kOnePoint, class Real, class T>
void designs_over_run(const ManyDesignsTask<Real>& task, std::size_t first, const Design<T>& design,
                      const Run& run) {
  constexpr unsigned kMotion = kSet & ~unsigned{transmission};
  const HalfDesign<T> half(design, run.side);
  const T half_assembly = T(0.5) * design.assembly;
  const Transmission<T> transmission_of(design);
  const auto point = [&](std::size_t index) {
    const std::size_t at = index * task.designs + first;
    return Vec2<T>{T::load(task.point_u + at), T::load(task.point_v + at)};
  };
  const PointOnly<T> point_only(design, half, kOnePoint ? point(0) : Vec2<T>{});
  for (std::size_t i = run.begin; i < run.end; ++i) {
    const T sin(task.sin[i]), versine(task.versine[i]);
    const std::size_t at_row = task.order[i] * task.designs + first;
    const Triangle<T> at(half.closure, versine, half_assembly, needs_inverse_root<kSet>);
    Writer<kSet, Real> write{task.columns, at_row, at_row};
    if constexpr (has(kSet, transmission)) transmission_of(at, write);
    if constexpr (kMotion == position && kOnePoint) {
      point_only(sin, versine, at, write);
    } else if constexpr (kMotion != 0) {
      const LinkMotion<kSet, T> links(design, half, sin, versine, at);
      for (std::size_t p = 0; p < task.points; ++p) {
        write_point<kSet>(design, links, point(p), write);
        write.at += task.rows * task.designs;
      }
    }
  }
}

template <unsigned kSet, bool kOnePoint, class Real>
[[gnu::flatten]] void many_designs(const ManyDesignsTask<Real>& given) {
  const ManyDesignsTask<Real> task = given;
  constexpr std::size_t lanes = Lanes<Real>::kSize;
  for (std::size_t start = task.first; start < task.last; start += lanes) {
    const std::size_t first = start + lanes <= task.last ? start : task.last - lanes;
    const auto design = load_design(task, first);
    for (std::size_t run = 0; run < task.run_count; ++run) {
      designs_over_run<kSet, kOnePoint>(task, first, design, task.runs[run]);
    }
  }
}

template <unsigned kSet, class Real>
void many_designs(const ManyDesignsTask<Real>& task) {
  // Positions of one point have a shorter form; with motion or gradient it does not pay.
  if constexpr ((kSet & ~unsigned{transmission}) == position) {
    if (task.points == 1) return many_designs<kSet, true>(task);
  }
  many_designs<kSet, false>(task);
}

template <class Real, std::size_t... kIndex>
void make_kernels(Kernels<Real>& kernels, std::index_sequence<kIndex...>) {
  kernels.lanes = Lanes<Real>::kSize;
  kernels.one_design = [](std::size_t instance, const OneDesignTask<Real>& task) {
    constexpr void (*table[])(const OneDesignTask<Real>&) = {
        one_design<instance_quantities(kIndex), Real>...};
    table[instance](task);
  };
  kernels.many_designs = [](std::size_t instance, const ManyDesignsTask<Real>& task) {
    constexpr void (*table[])(const ManyDesignsTask<Real>&) = {
        many_designs<instance_quantities(kIndex), Real>...};
    table[instance](task);
  };
}

}  // namespace

void get_kernels(Kernels<double>& kernels) {
  make_kernels(kernels, std::make_index_sequence<kInstances>{});
}

void get_kernels(Kernels<float>& kernels) {
  make_kernels(kernels, std::make_index_sequence<kInstances>{});
}

}  // namespace cognate::batch::COGNATE_ISA
