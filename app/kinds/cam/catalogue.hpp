/// @file What a cam's file may ask for, as data: for `cognate list`, for the documents, for the
/// tests.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/cam/motion_law.hpp"
#include "app/documents/catalogue.hpp"
#include "app/documents/mechanism_catalogue.hpp"

namespace cognate::app {

/// The values of `follower.type`, each with the keys of lengths that it has.
std::span<const KeyedEntry> cam_followers();

/// The tables of `kind = "cam"` and their keys.
std::span<const KeyedEntry> cam_tables();

/// Keys of the metrics of a cam besides those that all designs have.
std::span<const Metric> cam_metrics();

/// A motion law and the greatest velocity, acceleration and jerk of a rise of 1 over a cam angle of
/// 1, computed from the law itself and as handbooks print them; infinite where acceleration jumps.
/// Laws with parameters have no factors of their own.
struct MotionLawEntry {
  std::string_view name;
  std::string_view meaning;
  std::optional<cam::PeakFactors> factors;
  std::optional<cam::PeakFactors> handbook;
};

/// Every value of `motion.law`.
std::vector<MotionLawEntry> motion_laws();

}  // namespace cognate::app
