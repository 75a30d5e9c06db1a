/// @file The mechanism that two guiding dyads make with the body between them.
#pragma once

#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/linkage/double_slider.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/guide_bar.hpp"
#include "analysis/linkage/slider_crank.hpp"
#include "analysis/mechanism/mechanism.hpp"
#include "synthesis/exact/motion/dyad.hpp"

namespace cognate::synthesis {

/// Which mechanism two dyads make; the first dyad's link is driven where it is a crank.
///
///     rr + rr  FourBar, the body its coupler; its coupler point is the body's origin
///     rr + pr  SliderCrank, the body its coupler (the link is the crank, in either order)
///     rr + rp  OscillatingBlock, the body its rod (in either order)
///     pr + pr  EllipticTrammel, the body its link
///     rp + rp  OldhamCoupling, the body its disc
///     pr + rp  a chain: a driving slider and an RPR dyad, the body its bar
using GuidedType = std::variant<FourBar, SliderCrank, OscillatingBlock, EllipticTrammel,
                                OldhamCoupling, Mechanism<double>>;

/// Why two dyads make no mechanism.
enum class PairingFault {
  none,
  shared_moving_pivot,  ///< both hold the body by one point: it may turn
  shared_fixed_pivot,   ///< both turn about one point: body and links are one lever
  no_link,              ///< a link has no length: its pivots are one point, a pin in the frame
  parallel_lines,       ///< two slides in one direction: the body may slide and not turn
};
std::string_view sentence(PairingFault fault);

/// Where the mechanism stands at a pose: the coordinate of its drive (angle of crank or floating
/// link from the x axis, or displacement of a driving slider) and the side on which its dyad is
/// assembled (`open` where it has one side only).
struct DriveStation {
  double drive = 0;
  Assembly side = Assembly::open;
};

/// The mechanism, and where it stands at each pose.
struct GuidedMechanism {
  PairingFault fault = PairingFault::none;
  GuidedType type;                     ///< in the assembly of the first pose
  Mechanism<double> chain;             ///< the same as a chain
  int body = 0;                        ///< number of the guided body in `chain`
  Pose body_in_link;                   ///< the guided body's axes in those of that body of `chain`
  std::vector<DriveStation> stations;  ///< one for each pose; sides differ where a branch or
                                       ///< circuit is left
};

/// The mechanism of two dyads that guide a body through `poses`. With a fault all else is empty.
GuidedMechanism guided_mechanism(const GuidingDyad& first, const GuidingDyad& second,
                                 std::span<const Pose> poses);

}  // namespace cognate::synthesis
