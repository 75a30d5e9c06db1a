#include "analysis/machine/torque_breakpoints.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>

#include "analysis/numbers/constants.hpp"

namespace cognate::machine {
namespace {

constexpr std::size_t kSamplesOfATurn = 3072;
/// What jumps by less, in parts of the mean of the torques' magnitudes, is left to the control of
/// errors; so are jumps beyond a number.
constexpr double kJump = 0.01;
constexpr std::size_t kMostBreaks = 6000;

std::size_t samples_of(double period) {
  return kSamplesOfATurn * static_cast<std::size_t>(std::max(1.0, std::round(period / (kTurn))));
}

/// The interval's half with the greater change, again and again: at a jump all of it remains.
template <class Function>
std::optional<double> jump_between(Function&& f, double from, double at_from, double to,
                                   double at_to, double least) {
  while (std::abs(at_to - at_from) >= least) {
    const double middle = std::midpoint(from, to);
    if (middle <= from || middle >= to) return to;
    const double at = f(middle);
    if (std::abs(at - at_from) >= std::abs(at_to - at)) {
      to = middle;
      at_to = at;
    } else {
      from = middle;
      at_from = at;
    }
  }
  return std::nullopt;
}

}  // namespace

/// All that acts at a speed, at the samples, and the mean of its magnitudes.
struct TorqueBreakpoints::Torque {
  double omega = 0, time = 0;
  double mean = 0;
  std::vector<double> values;
};

TorqueBreakpoints::TorqueBreakpoints(const Machine& machine)
    : period_(machine.period),
      limits_(0, machine.period, samples_of(machine.period)),
      breaks_(machine.breaks),
      stretches_(limits_.samples()) {
  std::ranges::sort(breaks_);
}

void TorqueBreakpoints::look(const Machine& machine, std::span<const double> speeds, double time) {
  std::vector<Torque> torques;
  for (const double omega : speeds) {
    torques.push_back({omega, time, 0, std::vector<double>(limits_.samples())});
  }
  for (std::size_t i = 0; i < limits_.samples(); ++i) {
    machine.move_to(limits_.place(i));
    for (Torque& torque : torques) {
      const Torques acting = machine.torques(torque.omega, time);
      torque.values[i] = acting.sum();
      const double size = std::abs(acting.motor) + std::abs(acting.load);
      if (std::isfinite(size)) torque.mean += size / static_cast<double>(limits_.samples());
    }
  }
  for (const Torque& torque : torques) {
    number_intervals();
    find_jumps(machine, torque);
  }
  number_intervals();
  for (const Torque& torque : torques) limits_.shorten(torque.values, stretches_, torque.mean);
}

/// Looks between neighbouring samples whose change is one that the samples beside them do not show.
void TorqueBreakpoints::find_jumps(const Machine& machine, const Torque& torque) {
  const std::vector<double>& f = torque.values;
  const double least = kJump * torque.mean;
  if (!(least > 0)) return;
  const auto value = [&](double phi) {
    machine.move_to(phi);
    return machine.torques(torque.omega, torque.time).sum();
  };
  const auto goes_on = [&](std::size_t a, std::size_t b, std::size_t c) {
    return stretches_[a] == stretches_[c] && std::abs(f[a] - 2 * f[b] + f[c]) < 0.5 * least;
  };
  const std::size_t count = f.size(), known = breaks_.size();
  for (std::size_t i = 0; i + 1 < count && breaks_.size() < kMostBreaks; ++i) {
    if (stretches_[i] != stretches_[i + 1] || !(std::abs(f[i + 1] - f[i]) >= least)) continue;
    if (i > 0 && goes_on(i - 1, i, i + 1) && i + 2 < count && goes_on(i, i + 1, i + 2)) continue;
    const auto jump =
        jump_between(value, limits_.place(i), f[i], limits_.place(i + 1), f[i + 1], least);
    if (jump) breaks_.push_back(*jump);
  }
  std::inplace_merge(breaks_.begin(), breaks_.begin() + static_cast<std::ptrdiff_t>(known),
                     breaks_.end());
}

void TorqueBreakpoints::number_intervals() {
  auto next = breaks_.begin();
  int stretch = 0;
  for (std::size_t i = 0; i < limits_.samples(); ++i) {
    for (; next != breaks_.end() && *next < limits_.place(i); ++next) ++stretch;
    stretches_[i] = stretch;
  }
}

Machine TorqueBreakpoints::cut(Machine machine) const {
  machine.breaks = breaks_;
  return machine;
}

}  // namespace cognate::machine
