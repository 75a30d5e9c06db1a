/// @file What the bodies and points of the simple mechanisms are called.
#pragma once

#include "problems/mechanism/named_mechanism.hpp"
#include "problems/mechanism/named_parts.hpp"

namespace cognate::problems {

/// Bodies crank, coupler, rocker; points A, B, C, D and, with a coupler point, P.
NamedParts parts_of(const FourBar& linkage);

/// Bodies crank, coupler, slider; points A, B, C.
NamedParts parts_of(const SliderCrank& mechanism);

/// Bodies crank, slider (the block), guide; points A, B, D (the guide's pivot).
NamedParts parts_of(const GuideBar& mechanism);

/// Bodies crank, block, rod; points A, B, D (the block's pivot).
NamedParts parts_of(const OscillatingBlock& mechanism);

/// Bodies crank, coupler, rod; points A, B, C.
NamedParts parts_of(const FixedBlock& mechanism);

/// Bodies crank, block, yoke; points A, B, C (where slot and slide line cross).
NamedParts parts_of(const ScotchYoke& mechanism);

/// Bodies lever, block, slider; points A, B (the slider's pin).
NamedParts parts_of(const TangentGenerator& mechanism);

/// Bodies link, first-block, second-block; points A, B (the link's pins).
NamedParts parts_of(const EllipticTrammel& mechanism);

/// Bodies driver, driven, disc; points A, D (the shafts), C (where the tongues cross).
NamedParts parts_of(const OldhamCoupling& mechanism);

/// The body whose motion is the mechanism's output: the follower, the sliding or driven one.
int output_of(MechanismType type);

}  // namespace cognate::problems
