/// @file Whether two plates of one layer collide anywhere on a motion, decided for every position.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "analysis/layers/plates.hpp"
#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/mechanism/mechanism.hpp"

namespace cognate {

/// How two plates stand to each other over a motion.
enum class Passage {
  free,       ///< proven: they keep more than the clearance from each other at every position
  collides,   ///< proven: at some position they come closer
  unresolved  ///< neither could be proven; to be treated as a collision
};

/// Two plates to be compared.
struct PlatePair {
  const Plate* first = nullptr;
  const Plate* second = nullptr;
};

struct PairPassage {
  Passage passage = Passage::free;
  double drive = 0;  ///< where it is not free: the first position in the order of the motion
};

struct Collisions {
  std::vector<PairPassage> pairs;  ///< in the order given
  std::size_t cells = 0;           ///< of the drive that were examined
  bool complete = true;            ///< else it was stopped, and pairs may wrongly be free
};

/// Of each pair whether its plates come closer than `clearance` on the ranges of `motion`, which is
/// one of `mechanism`.
///
/// The drive is divided into cells. In each the mechanism's own closure, evaluated with strips,
/// encloses the positions of all bodies for every position of the drive in the cell, and two plates
/// are free in it where a line separates the enclosures with the clearance to spare: the one at
/// right angles to the shortest connection in the middle of the cell. A cell in which that fails is
/// halved, the earlier half first. A pair is given up as not free where the enclosures leave no
/// more than 1e-9 of the mechanism's size to decide, after 45 halvings (near a position that is not
/// determined), or after 200,000 cells; it collides where the enclosures overlap so far that the
/// plates do, in one of the cells up to there. Once `stop`, asked at every cell, says so, it ends.
Collisions find_collisions(const Mechanism<double>& mechanism, const AssemblyRanges& motion,
                           std::span<const PlatePair> pairs, double clearance,
                           const std::function<bool()>& stop = {});

}  // namespace cognate
