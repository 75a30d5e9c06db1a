/// @file Which body of a design is guided through poses, and where it is taken.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "problems/mechanism/named_mechanism.hpp"
#include "synthesis/exact/motion/pose.hpp"

namespace cognate::app {

struct GuidedBody {
  int body = 0;
  /// Where the mechanism, in the assembly that it is described in, takes the body's axes; empty
  /// where it cannot be assembled.
  std::vector<std::optional<synthesis::Pose>> reached;
  synthesis::Pose target_in_body;  ///< the axes that the targets are poses of, in the body's
};

/// The moving body whose places at the drive coordinates `stations`, one for each of `targets`,
/// follow the targets best: the body's own axes may lie anywhere in it, and are those that make the
/// mean difference vanish. Where it is known which one is guided, `known` alone. Empty where no
/// body has a place at any station, or the numbers of stations and targets differ.
std::optional<GuidedBody> guided_body(const problems::NamedMechanism& mechanism,
                                      std::span<const double> stations,
                                      std::span<const synthesis::Pose> targets,
                                      std::optional<int> known = {});

}  // namespace cognate::app
