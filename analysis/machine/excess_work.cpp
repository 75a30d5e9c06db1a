#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/machine/adaptive_steps.hpp"
#include "analysis/machine/flywheel.hpp"
#include "analysis/machine/pieces.hpp"
#include "analysis/machine/torque_breakpoints.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate::machine {
namespace {

constexpr std::size_t kAskOfWork = 256;

/// ∫ (M − M̄) dφ at a constant speed, over a period.
class ExcessWork {
 public:
  ExcessWork(const Machine& machine, const TorqueBreakpoints& breakpoints, double phi0,
             double omega, const Accuracy& accuracy)
      : machine_(machine),
        breakpoints_(breakpoints),
        accuracy_(accuracy),
        pieces_(machine, phi0),
        phi0_(phi0),
        omega_(omega),
        size_(std::max(turnover(machine, omega), std::numeric_limits<double>::min())),
        stepper_([this](const State&, State& slope, double phi) { slope = {excess(phi)}; },
                 accuracy.relative) {}

  double range() {
    if (!integrate()) return std::numeric_limits<double>::quiet_NaN();
    mean_ = stepper_.y()[0] / machine_.period;
    least_ = greatest_ = 0;
    return integrate() ? (greatest_ - least_) * size_ : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  using State = AdaptiveSteps::State;

  double excess(double phi) {
    machine_.move_to(pieces_.inside(place_.piece, phi));
    return machine_.torques(omega_, 0).sum() / size_ - mean_;
  }

  void include(double work) {
    least_ = std::min(least_, work);
    greatest_ = std::max(greatest_, work);
  }

  /// The end of the last step, and the place in it where the excess vanishes.
  void note() {
    include(stepper_.y()[0]);
    const auto f = [this](double phi) { return excess(phi); };
    const double before = f(stepper_.x_before()), after = f(stepper_.x());
    if (!(before * after < 0)) return;
    const double at = bracket_zero(f, stepper_.x_before(), before, stepper_.x(), after).first;
    include(stepper_.at(at)[0]);
  }

  bool integrate() {
    place_ = pieces_.place(phi0_, 1);
    State y{};
    const bool failed = integrate_round(pieces_, place_, stepper_, y, [&](double to) {
      while (stepper_.x() < to) {
        const double longest = breakpoints_.longest_step(stepper_.x());
        if (!stepper_.step(std::min(to, stepper_.x() + longest)) || is_over()) return true;
        note();
      }
      return false;
    });
    return !failed;
  }

  bool is_over() {
    if (++taken_ >= accuracy_.most_steps) return true;
    return taken_ % kAskOfWork == 0 && accuracy_.stop && accuracy_.stop();
  }

  const Machine& machine_;
  const TorqueBreakpoints& breakpoints_;
  Accuracy accuracy_;
  Pieces pieces_;
  double phi0_, omega_, size_;
  double mean_ = 0, least_ = 0, greatest_ = 0;
  Place place_;
  std::size_t taken_ = 0;
  AdaptiveSteps stepper_;
};

}  // namespace

double greatest_excess_work(const Machine& machine, double phi0, double omega,
                            const Accuracy& accuracy) {
  TorqueBreakpoints breakpoints(machine);
  breakpoints.look(machine, {&omega, 1});
  return ExcessWork(breakpoints.cut(machine), breakpoints, phi0, omega, accuracy).range();
}

}  // namespace cognate::machine
