#include "analysis/mechanism/transmission_extremes.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/mechanism/assembly_probe.hpp"
#include "analysis/mechanism/run_places.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate {
namespace {

/// Goes through assembly ranges and keeps the extremes of one dyad's angle.
class Extremes {
 public:
  Extremes(const Mechanism<double>& mechanism, int dyad) : probe_(mechanism), dyad_(dyad) {}

  void add(const AssemblyRanges& assembly_ranges, const AssemblyRange& run) {
    Dual last;
    double last_drive = run.from;
    if (run.from_dyad == dyad_) include_dead(closure(run, run.from), run.from);
    if (run.to_dyad == dyad_) include_dead(closure(run, run.to), run.to);
    for (const Change& change : run.changes) {
      if (change.dyad == dyad_ && change.determined) {
        include_dead(closure(run, change.drive), change.drive);
      }
    }
    for (const double drive : run_places(assembly_ranges, run)) {
      const DyadClosure<Dual>& here = closure(run, drive);
      const Dual cosine = here.cosine;
      if (!std::isfinite(cosine.value)) continue;
      if (!is_dead_point(run, drive)) include(here, drive);
      if (last.rate * cosine.rate < 0) {
        const auto rate = [&](double at) { return closure(run, at).cosine.rate; };
        const double extreme =
            better_end(rate, bracket_zero(rate, last_drive, last.rate, drive, cosine.rate));
        include(closure(run, extreme), extreme);
      }
      last = cosine;
      last_drive = drive;
    }
  }

  std::optional<TransmissionExtremes> result() const { return result_; }

 private:
  const DyadClosure<Dual>& closure(const AssemblyRange& run, double drive) {
    return probe_.closure(run, drive, dyad_);
  }

  bool is_dead_point(const AssemblyRange& run, double drive) const {
    return (drive == run.from && run.from_dyad == dyad_) ||
           (drive == run.to && run.to_dyad == dyad_);
  }

  /// Where the links of the dyad are in line, to rounding: μ is 0 or π, which a root of what
  /// rounding leaves is not.
  void include_dead(const DyadClosure<Dual>& at, double drive) {
    include({drive, at.cosine.value < 0 ? kPi : 0.0 * at.cosine.value});
  }

  void include(const DyadClosure<Dual>& at, double drive) {
    include({drive, std::atan2(std::abs(at.sine.value), at.cosine.value)});
  }

  void include(const AngleAt& here) {
    if (!std::isfinite(here.angle)) return;
    if (!result_) result_ = {here, here};
    if (here.angle < result_->least.angle) result_->least = here;
    if (here.angle > result_->greatest.angle) result_->greatest = here;
  }

  AssemblyProbe probe_;
  int dyad_;
  std::optional<TransmissionExtremes> result_;
};

}  // namespace

double TransmissionExtremes::acute_least() const {
  return std::min(least.angle, kPi - greatest.angle);
}

double TransmissionExtremes::greatest_pressure() const {
  return kRightAngle - acute_least();
}

std::optional<TransmissionExtremes> transmission_extremes(const Mechanism<double>& mechanism,
                                                          const AssemblyRanges& assembly_ranges,
                                                          int dyad) {
  Extremes extremes(mechanism, dyad);
  for (const AssemblyRange& run : assembly_ranges.runs) extremes.add(assembly_ranges, run);
  return extremes.result();
}

}  // namespace cognate
