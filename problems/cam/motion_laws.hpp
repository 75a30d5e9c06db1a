/// @file The motion laws that files can name: each law's word and what `cognate list` says of it.
/// The laws themselves, and the factors that handbooks print, are in analysis/cam/motion_law.hpp.
#pragma once

#include <string_view>

#include "analysis/cam/motion_law.hpp"

namespace cognate::problems {

struct MotionLawDeclaration {
  cam::MotionLaw law;
  std::string_view word;  ///< `law = "..."` of `[[motion]]`
  std::string_view meaning;
  bool has_parameters = false;  ///< so that it has no peak factors of its own
  std::string_view vdi_name{};  ///< in VDI 2143; empty where the guideline has no such law
};

/// In the order of `MotionLaw`, in which lists show them.
inline constexpr MotionLawDeclaration kMotionLaws[] = {
    {cam::MotionLaw::dwell, "dwell", "the follower stays where it is", false, "Rast"},
    {cam::MotionLaw::constant_velocity, "constant-velocity", "knocks at its ends", false, "Gerade"},
    {cam::MotionLaw::constant_acceleration, "constant-acceleration",
     "parabolic: the minimum acceleration, which jumps", false, "quadratische Parabel"},
    {cam::MotionLaw::harmonic, "harmonic", "half a cosine: acceleration jumps against a dwell",
     false, "einfache Sinuslinie"},
    {cam::MotionLaw::cycloidal, "cycloidal", "acceleration a full sine: smooth at dwells", false,
     "geneigte Sinuslinie (Bestehorn)"},
    {cam::MotionLaw::polynomial_345, "3-4-5",
     "polynomial without velocity and acceleration at its ends", false, "Polynom 5. Grades"},
    {cam::MotionLaw::polynomial_4567, "4-5-6-7", "and without jerk there"},
    {cam::MotionLaw::modified_sine, "modified-sine", "low torque at dwells", false,
     "modifizierte Sinuslinie"},
    {cam::MotionLaw::modified_trapezoid, "modified-trapezoid", "low acceleration, smooth at dwells",
     false, "modifiziertes Beschleunigungstrapez"},
    {cam::MotionLaw::modified_constant_velocity, "modified-constant-velocity",
     "constant over the middle half of the segment"},
    {cam::MotionLaw::double_harmonic, "double-harmonic",
     "smooth at the dwell below, not above, where the return follows"},
    {cam::MotionLaw::universal, "universal",
     "sine, constant, cosine and zero acceleration by shares", true},
    {cam::MotionLaw::polynomial, "polynomial", "by conditions", true},
    {cam::MotionLaw::spline, "spline", "through points", true}};

}  // namespace cognate::problems
