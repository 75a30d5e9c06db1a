/// @file The keys of `[constraints]`, `[solve]` and of how a design is driven, which the kinds
/// share.
#pragma once

#include "problems/linkage/linkage_limits.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/toml/keys.hpp"

namespace cognate::problems::reading {

inline constexpr IntegerRule kStartCount{1, 1'000'000};

/// `[constraints]` on what lengths alone decide.
inline constexpr Key<Constraints> kMobilityKeys[] = {
    key<&Constraints::required_class>(
        "class",
        "\"crank-rocker\", \"double-crank\", \"rocker-crank\", \"double-rocker\", "
        "\"triple-rocker\", \"grashof\" or \"non-grashof\""),
    key<&Constraints::transmission_angle>("transmission_angle_deg", "[min, max] over the motion",
                                          kTransmissionAngle),
    key<&Constraints::link_ratio_max>("link_ratio_max", "longest over shortest link", kRatio),
    key<&Constraints::time_ratio>("time_ratio", "[min, max] of K; with class = \"crank-rocker\"",
                                  kRatio)};

/// On the error, whichever a problem has.
inline constexpr Key<Constraints> kErrorKeys[] = {
    own_key<Constraints>("rms_error_max",
                         "paths and motions: the most root mean square of the distances",
                         KeyForm::number),
    own_key<Constraints>("rms_error_deg_max", "functions by least squares: likewise of the angles",
                         KeyForm::number),
    own_key<Constraints>("max_error_deg_max", "functions by minimax: the maximum error allowed",
                         KeyForm::number)};

/// On places.
inline constexpr Key<Constraints> kPlaceLimitKeys[] = {
    key<&Constraints::pivot_region>("pivot_region",
                                    "[[xmin, ymin], [xmax, ymax]] of the fixed pivots"),
    own_key<Constraints>("clearance",
                         "[[constraints.clearance]], over the full turn: point = "
                         "\"coupler-point\", \"B\" or \"C\", inside or outside = [[xmin, "
                         "ymin], [xmax, ymax]]")};

/// On how the positions are reached.
inline constexpr Key<Constraints> kDefectKeys[] = {
    key<&Constraints::no_branch_defect>("no_branch_defect", "true (default) or false"),
    key<&Constraints::no_order_defect>("no_order_defect", "true (default) or false"),
    key<&Constraints::no_circuit_defect>("no_circuit_defect", "true (default) or false")};

inline constexpr Key<Constraints> kLoopKeys[] = {key<&Constraints::no_extra_loop>(
    "no_extra_loop",
    "true (default) or false: the whole coupler curve follows a closed target curve")};

/// `[solve]`, in the order of its table. How many designs there may be, and of what they are best,
/// depends on the kind.
inline constexpr Key<Solve> kSearchKeys[] = {
    key<&Solve::solver>("solver", "one of the solvers above (default \"auto\")"),
    key<&Solve::starts>("starts", "how many starts are refined (default: chosen by the problem)",
                        kStartCount),
    own_key<Solve>("designs",
                   "how many different designs to return, 1 to 100 (default 3); where the "
                   "solutions are finitely many: to 10000, by default all",
                   KeyForm::integer)};

inline constexpr Key<Solve> kLossKeys[] = {
    key<&Solve::loss>("loss",
                      "none (default), huber, soft-l1, cauchy, arctan, tukey: least squares of "
                      "paths and functions that gross errors in the target do not govern"),
    key<&Solve::loss_scale>(
        "loss_scale",
        "with a loss: the error from which it differs, a length for paths, radians for functions",
        kErrorScale)};

inline constexpr Key<Solve> kStoppingKeys[] = {key<&Solve::tolerance>(
    "tolerance", "relative change of the error at which a refinement stops", kTolerance)};

inline constexpr NumberRule kRobustShare{
    [](double x) { return x >= 0.5 && x <= 0.9999; },
    "a share of what is made from 0.5 to 0.9999, or \"worst\""};
/// What `robust` is instead of a share where the worst case is to be least.
inline constexpr std::string_view kRobustWorst = "worst";

inline constexpr Key<Solve> kRobustKeys[] = {own_key<Solve>(
    "robust",
    "with [tolerance]: the share of what is made, 0.5 to 0.9999, whose error is to be least, or "
    "\"worst\": of all that the tolerances allow; paths, also of chains, functions and poses by "
    "least squares")};

inline constexpr Key<Solve> kCertificateKeys[] = {
    key<&Solve::certify>("certify",
                         "true: prove how near the best design is to the best possible; timed "
                         "paths and functions by least squares (at most 60 s, or what "
                         "--time-limit leaves)"),
    key<&Solve::certify_gap>("certify_gap",
                             "the relative gap at which a certificate is complete (default 1e-3)",
                             kTolerance)};

}  // namespace cognate::problems::reading
