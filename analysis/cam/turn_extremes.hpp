/// @file Extremes over a whole turn of a cam, over its rises or its falls.
#pragma once

#include <optional>
#include <vector>

#include "analysis/cam/extremes.hpp"
#include "analysis/cam/motion_programme.hpp"
#include "analysis/cam/quantity.hpp"

namespace cognate::cam {

/// A place on a programme: the share `t` of a piece, which stands at cam angle `angle`.
struct TurnPlace {
  double angle = 0;
  int piece = 0;
  double t = 0;
};

struct ExtremeAt {
  TurnPlace place;
  double value = 0;
};

struct TurnExtremes {
  ExtremeAt least;
  ExtremeAt greatest;
};

/// Which part of the turn is meant; a stretch has its ends.
enum class MotionPart { whole, rises, falls, dwells };

/// A function of the motion that is analytic on each piece of a programme.
class MotionFunction {
 public:
  template <class F>
  requires(!std::is_same_v<std::remove_cvref_t<F>, MotionFunction>)
      MotionFunction(const F& f)  // NOLINT(google-explicit-constructor): as a function argument
      : object_(&f), call_([](const void* object, const FollowerMotion<double>& m) -> double {
          return (*static_cast<const F*>(object))(m);
        }) {}
  double operator()(const FollowerMotion<double>& m) const { return call_(object_, m); }

 private:
  const void* object_;
  double (*call_)(const void*, const FollowerMotion<double>&);
};

/// The extremes of `f` over a stretch of the turn, to rounding; where there are equal ones the
/// first. Nothing where the stretch is empty.
std::optional<TurnExtremes> turn_extremes(const MotionProgramme& programme, MotionPart stretch,
                                          MotionFunction f);

/// Every local maximum of `f` over a stretch whose value is at least `floor`, in order.
std::vector<ExtremeAt> local_maxima(const MotionProgramme& programme, MotionPart stretch,
                                    MotionFunction f, double floor);

/// The extremes of a quantity of `cam`.
std::optional<TurnExtremes> turn_extremes(const MotionProgramme& programme, MotionPart stretch,
                                          const CamSystem<double>& cam, CamQuantity quantity);

/// The motion at `place`.
FollowerMotion<double> motion_at(const MotionProgramme& programme, const TurnPlace& place);

}  // namespace cognate::cam
