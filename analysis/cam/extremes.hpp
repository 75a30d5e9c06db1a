/// @file All local extremes and zeros of an analytic function on an interval, to rounding.
#pragma once

#include <type_traits>
#include <utility>
#include <vector>

namespace cognate::cam {

/// A real function of one variable, by reference: the callable must outlive it.
class FunctionRef {
 public:
  template <class F>
  requires(!std::is_same_v<std::remove_cvref_t<F>, FunctionRef>)
      FunctionRef(F&& f)  // NOLINT(google-explicit-constructor): as a function argument
      : object_(const_cast<void*>(static_cast<const void*>(&f))),
        call_([](void* object, double x) -> double {
          return (*static_cast<std::remove_reference_t<F>*>(object))(x);
        }) {}
  double operator()(double x) const { return call_(object_, x); }

 private:
  void* object_;
  double (*call_)(void*, double);
};

struct Extreme {
  double at = 0;
  double value = 0;
};

struct Extremes {
  Extreme least;
  Extreme greatest;
};

/// Every place in [from, to] where f has a local minimum or maximum, its ends among them, in order.
/// f is analytic on the interval (continuous at its ends); poles and kinks just outside are allowed
/// and cost time. `scale` is the size of f on all of the problem: waves smaller than about 1e-13 of
/// it, or of f nearby where that is greater, are rounding, not extremes. A function that is
/// constant to rounding has only its ends. Where rounding of f itself is greater, up to 1e-12 or as
/// the rounding of a steep function's argument explains, waves below that are left out too.
///
/// f is represented by Chebyshev interpolants of degree 24 on as many subintervals as it needs for
/// rounding accuracy (checked between the nodes), and the zeros of their derivatives are isolated
/// by bounds on Chebyshev series, so that none is lost: no grid (the way of Chebfun: Battles &
/// Trefethen 2004). Values are f's own at these places. What f does between samples without a trace
/// in any of the first 27 is not seen: a spike of a hundredth of the interval, say.
///
/// The cost: 28 evaluations for a sine's whole wave, some 80 for the pressure angle of a rise. A
/// jump or a kink inside is closed in on by halving, a value that is not finite is left out, and
/// after 4000 subintervals samples stand for extremes: about 1e5 evaluations for a function that is
/// noise.
void local_extremes(FunctionRef f, double from, double to, double scale,
                    std::vector<Extreme>& extremes);

/// The least and the greatest value of f on [from, to]; as above, but where bounds show that
/// neither can be, nothing is searched. Of values that are equal but for rounding either may be
/// given.
Extremes extremes(FunctionRef f, double from, double to, double scale);

/// Where f is 0 inside (from, to), in order; by the same means. A zero that f touches without
/// changing its sign may be missed or found twice; a jump through 0 counts as one.
void zeros(FunctionRef f, double from, double to, double scale, std::vector<double>& at);

}  // namespace cognate::cam
