#include "analysis/mechanism/transmission_extremes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/mechanism/course_probe.hpp"
#include "analysis/mechanism/zeros.hpp"

namespace cognate {
namespace {

/// Goes through a course and keeps the extremes of one dyad's angle.
class Extremes {
 public:
  Extremes(const Mechanism<double>& mechanism, int dyad) : probe_(mechanism), dyad_(dyad) {}

  void add(const CourseRun& run, int cells) {
    Dual last;
    double last_drive = run.from;
    for (const double drive : crowded(run.from, run.to, cells)) {
      const DyadClosure<Dual>& here = closure(run, drive);
      const Dual cosine = here.cosine;
      if (!std::isfinite(cosine.value)) continue;
      include(here, drive);
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
  const DyadClosure<Dual>& closure(const CourseRun& run, double drive) {
    return probe_.closure(run, drive, dyad_);
  }

  void include(const DyadClosure<Dual>& at, double drive) {
    const AngleAt here{drive, std::atan2(std::abs(at.sine.value), at.cosine.value)};
    if (!std::isfinite(here.angle)) return;
    if (!result_) result_ = {here, here};
    if (here.angle < result_->least.angle) result_->least = here;
    if (here.angle > result_->greatest.angle) result_->greatest = here;
  }

  CourseProbe probe_;
  int dyad_;
  std::optional<TransmissionExtremes> result_;
};

}  // namespace

double TransmissionExtremes::acute_least() const {
  return std::min(least.angle, std::numbers::pi - greatest.angle);
}

double TransmissionExtremes::greatest_pressure() const {
  return std::numbers::pi / 2 - acute_least();
}

std::optional<TransmissionExtremes> transmission_extremes(const Mechanism<double>& mechanism,
                                                          const Course& course, int dyad) {
  Extremes extremes(mechanism, dyad);
  for (const CourseRun& run : course.runs) extremes.add(run, course.cells(run));
  return extremes.result();
}

}  // namespace cognate
