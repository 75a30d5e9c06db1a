/// @file Why a mechanism cannot be assembled at a position of its drive.
#pragma once

#include <optional>
#include <span>

#include "analysis/mechanism/mechanism.hpp"

namespace cognate {

/// Why a dyad cannot be closed.
enum class AssemblyFaultKind {
  too_far_apart,      ///< RRR: distance > first + second, the lengths of the links
  too_near,           ///< RRR: distance < first − second, the longer less the shorter
  guide_too_far,      ///< RRP: the point's distance from the guide > first, the link's length
  inside_offset,      ///< RPR: the block's distance from the pivot < first, the offset
  parallel_guides,    ///< PRP, RPP: |sine| of the angle between the slides is zero
  parallel_supports,  ///< the guides of a driving floating link are parallel
  group_open          ///< a group: not reached from where it is drawn
};

/// The first dyad that cannot be closed, and the numbers that say so; −1: the drive itself.
struct AssemblyFault {
  AssemblyFaultKind kind = AssemblyFaultKind::too_far_apart;
  int dyad = 0;
  double distance = 0;
  double first = 0;
  double second = 0;
};

/// Empty where every dyad closes at `drive` (radians or length) with these signs of the assemblies.
/// A group counts as one that does not: only a motion from where it is drawn says whether it does.
std::optional<AssemblyFault> assembly_fault(const Mechanism<double>& mechanism, double drive,
                                            std::span<const double> sides);

/// With the assemblies of its description.
std::optional<AssemblyFault> assembly_fault(const Mechanism<double>& mechanism, double drive);

}  // namespace cognate
