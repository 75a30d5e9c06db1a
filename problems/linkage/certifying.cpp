#include "problems/linkage/certifying.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

using synthesis::Interval;
using synthesis::ProportionBox;
using synthesis::Proportions;

constexpr double kSearchShare = 0.1;  // of a certified run, for progress

Proportions proportions_of(const Constraints& constraints) {
  if (constraints.required_class == RequiredClass::crank_rocker) return Proportions::crank_shortest;
  if (constraints.required_class == RequiredClass::double_crank) return Proportions::frame_shortest;
  return Proportions::any;
}

}  // namespace

std::optional<double> largest_ratio(const std::array<Range, 4>& limits,
                                    const Constraints& constraints) {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for (const Range& range : limits) {
    least = std::min(least, range.min);
    greatest = std::max(greatest, range.max);
  }
  double ratio = least > 0 ? greatest / least : std::numeric_limits<double>::infinity();
  ratio = std::min(ratio, constraints.link_ratio_max.value_or(ratio));
  if (!std::isfinite(ratio)) return std::nullopt;
  return std::clamp(ratio, 1.0, 1 / kLeastLinkRatio);
}

std::string domain_text(const Constraints& constraints, const Given& given, double ratio,
                        bool ratio_given) {
  const auto& required = constraints.required_class;
  // At a change point the check of a design limits the transmission angle at the targets alone.
  const bool apart =
      constraints.transmission_angle && proportions_of(constraints) != Proportions::any;
  return fmt::format("four-bars{}{}, longest link at most {:g} times the shortest{}",
                     required ? fmt::format(" of class {}", to_string(*required)) : "",
                     given.assembly ? fmt::format(", assembly {}", to_string(*given.assembly))
                                    : ", both assemblies",
                     ratio, ratio_given ? "" : " (a limit of the certificate; the file has none)") +
         (apart ? ", those exactly at a change point left out" : "");
}

synthesis::LengthLimits certified_lengths(const std::array<Range, 4>& limits) {
  synthesis::LengthLimits lengths;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    lengths.least[i] = limits[i].min * (1 - 2 * kCheckTolerance);
    lengths.greatest[i] = limits[i].max * (1 + 2 * kCheckTolerance);
  }
  return lengths;
}

std::vector<ProportionBox> proportion_roots(const Constraints& constraints, const Given& given,
                                            const std::array<Range, 4>& limits, double ratio,
                                            const Range& phase) {
  ProportionBox box;
  box.proportions = proportions_of(constraints);
  const Range &crank = limits[0], &frame = limits[3];
  const double most = frame.max / crank.min, fewest = frame.min / crank.max;
  const double greatest = std::isfinite(most) ? std::min(ratio, most) : ratio;
  const double least = std::isfinite(fewest) ? std::max(1 / ratio, fewest) : 1 / ratio;
  constexpr double kSlack = 4 * kCheckTolerance;
  const double lowest = least / (1 + least) * (1 - kSlack);
  const double highest = greatest / (1 + greatest) + kSlack / (1 + greatest);
  box.side[0] = Interval(lowest, highest);
  if (box.proportions == Proportions::crank_shortest) {
    box.side[0].low = std::max(0.5, lowest);
  } else if (box.proportions == Proportions::frame_shortest) {
    box.side[0].high = std::min(0.5, highest);
  }
  if (box.side[0].low > box.side[0].high) return {};
  if (box.proportions == Proportions::any) {
    box.side[1] = Interval(-1, 1);
    box.side[2] = Interval(0, Interval::above(ratio / (1 + ratio)));
  } else {
    box.side[1] = Interval(0, Interval::above(kPi));
    box.side[2] = Interval(0, Interval::above(kRightAngle));
  }
  box.side[3] = Interval(phase.min, phase.max);
  std::vector<ProportionBox> roots;
  for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
    if (given.assembly && *given.assembly != assembly) continue;
    box.assembly = assembly == Assembly::open ? 1 : -1;
    roots.push_back(box);
  }
  return roots;
}

synthesis::ProportionLimits proportion_limits(const Constraints& constraints, double ratio) {
  using Class = synthesis::ProportionLimits::Class;
  synthesis::ProportionLimits limits;
  limits.greatest_ratio = ratio;
  const Range transmission = constraints.transmission_angle.value_or(Range{0, kPi});
  // As far as a check of the finished design lets the limits be passed.
  limits.transmission_min = std::max(0.0, transmission.min - 2 * kCheckTolerance);
  limits.transmission_max = std::min(kPi, transmission.max + 2 * kCheckTolerance);
  if (!constraints.required_class) return limits;
  switch (*constraints.required_class) {
    case RequiredClass::crank_rocker:
    case RequiredClass::double_crank:
      break;  // the box's proportions are those
    case RequiredClass::rocker_crank:
      limits.required = Class::rocker_shortest;
      break;
    case RequiredClass::double_rocker:
      limits.required = Class::coupler_shortest;
      break;
    case RequiredClass::grashof:
      limits.required = Class::grashof;
      break;
    case RequiredClass::triple_rocker:
    case RequiredClass::non_grashof:
      limits.required = Class::non_grashof;
      break;
  }
  return limits;
}

Run before_certificate(const Run& run, const Solve& solve) {
  if (!solve.certify) return run;
  run.enter(Phase::search, kSearchShare);
  return part_of(run, 0, kSearchShare);
}

bool CertificateRun::over() const {
  return deadline_.reached() || deadline_.spent() >= end_;
}

CertificateRun::CertificateRun(double upper, const Solve& solve, const Run& run,
                               const Deadline& deadline)
    : upper_(upper),
      target_(upper * (1 - solve.certify_gap)),
      run_(run),
      deadline_(deadline),
      end_(run.time_limit ? std::numeric_limits<double>::infinity()
                          : deadline.spent() + kCertificateSeconds) {
  run.enter(Phase::certificate);
}

synthesis::BranchOptions CertificateRun::options(double scale) const {
  synthesis::BranchOptions options;
  options.target = target_ / scale;
  options.threads = run_.threads;
  options.stop = [this] { return over(); };
  if (run_.progress) {
    options.progress = [this](double share, double) {
      run_.progress(kSearchShare + (1 - kSearchShare) * share, upper_);
    };
  }
  return options;
}

synthesis::StageOptions CertificateRun::stages(double scale) const {
  synthesis::StageOptions stages;
  for (const double share : {0.1, 0.5, 0.9}) {
    if (share * upper_ < target_) stages.targets.push_back(share * upper_ / scale);
  }
  const synthesis::BranchOptions last = options(scale);
  stages.targets.push_back(last.target);
  stages.threads = last.threads;
  stages.stop = last.stop;
  stages.progress = last.progress;
  return stages;
}

Certificate CertificateRun::state(const synthesis::BranchResult& result, double scale,
                                  std::string domain) const {
  if (!std::isfinite(result.lower)) {  // no box holds a design, not even the one found
    return {0, upper_, 1, false, result.boxes, domain + ", where no design lies"};
  }
  // A product of rounded numbers is not to exceed what was proved.
  const double lower = std::min(target_, result.lower * scale * (1 - 1e-14));
  return {lower,           upper_,       (upper_ - lower) / upper_,
          result.complete, result.boxes, std::move(domain)};
}

Certificate CertificateRun::state_exact(std::string domain) const {
  return {0, upper_, 0, true, 0, std::move(domain)};
}

}  // namespace cognate::problems
