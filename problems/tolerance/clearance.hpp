/// @file What the play of pins does.
#pragma once

#include <cstddef>

#include "problems/tolerance/figures.hpp"

namespace cognate::problems {

/// The figures of every pin with clearance, of quantity `judged`.
///
/// By virtual work a unit load on the quantity calls forth in a joint the reaction R whose product
/// with the offset of its pin in its hole is the change of the quantity: δq = −R·offset. A pin
/// anywhere within its clearance c moves it by |R|c at most; of a link with two pins this is the
/// change of its length by ±(c₁ + c₂) (Garrett & Hall, "Effect of tolerance and clearance in
/// linkage design", 1969). A loaded pin gives way to what its reaction F withstands: offset =
/// −c F/|F|, so that a load on the output alone moves it along with the load, by |R|c.
void add_clearances(const NamedMechanism& mechanism, const Tolerances& tolerances,
                    const ToleranceQuestion& question, std::size_t judged, ToleranceResult& result);

}  // namespace cognate::problems
