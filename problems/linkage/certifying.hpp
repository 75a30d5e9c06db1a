/// @file How a certificate's branch and bound is run and its result stated.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/result.hpp"
#include "synthesis/bounds/branch_and_bound.hpp"
#include "synthesis/bounds/path_bound.hpp"
#include "synthesis/bounds/staged_search.hpp"

namespace cognate::problems {

/// Seconds that a certificate may take where the run has no time limit.
inline constexpr double kCertificateSeconds = 60;
/// The largest ratio of two links looked at where neither bounds nor link_ratio_max give one.
inline constexpr double kCertifiedLinkRatio = 300;

/// The largest ratio of two links that `limits`, of crank, coupler, rocker and frame, and
/// `link_ratio_max` allow; empty where they allow any.
std::optional<double> largest_ratio(const std::array<Range, 4>& limits,
                                    const Constraints& constraints);

/// The domain in words: the class, the assemblies, the largest link ratio, and that linkages
/// exactly at a change point are left out where the transmission angle is limited over the full
/// turn.
std::string domain_text(const Constraints& constraints, const Given& given, double ratio,
                        bool ratio_given);

/// `limits` as far as a check of the finished design lets them be passed.
synthesis::LengthLimits certified_lengths(const std::array<Range, 4>& limits);

/// Root boxes of the proportions that the class, the limits of crank and frame and the largest
/// ratio allow, in the assemblies that the file allows, with the phase in [phase.min, phase.max].
std::vector<synthesis::ProportionBox> proportion_roots(const Constraints& constraints,
                                                       const Given& given,
                                                       const std::array<Range, 4>& limits,
                                                       double ratio, const Range& phase);

/// What the constraints ask of proportions beyond their root boxes.
synthesis::ProportionLimits proportion_limits(const Constraints& constraints, double ratio);

/// `run` for the search that comes before a certificate, where `solve` requests one: its progress
/// is then a part of the whole.
Run before_certificate(const Run& run, const Solve& solve);

/// Options for a run that ends at the gap requested or, at the latest, when its time is over;
/// `scale` brings bounds to the file's unit.
class CertificateRun {
 public:
  CertificateRun(double upper, const Solve& solve, const Run& run, const Deadline& deadline);

  /// Whether `upper` is no more than `rounding`: then nothing is left to prove.
  bool met_exactly(double rounding) const { return upper_ <= rounding; }
  synthesis::BranchOptions options(double scale) const;
  /// The same by stages, of which each that ends proves a bound.
  synthesis::StageOptions stages(double scale) const;
  Certificate state(const synthesis::BranchResult& result, double scale, std::string domain) const;
  /// Of designs that meet the target within rounding.
  Certificate state_exact(std::string domain) const;

 private:
  bool over() const;

  double upper_, target_;
  const Run& run_;
  const Deadline& deadline_;
  double end_;
};

}  // namespace cognate::problems
