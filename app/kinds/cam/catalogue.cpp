#include <fmt/core.h>

#include <cmath>
#include <optional>

#include "analysis/cam/motion_law.hpp"
#include "app/console/text_table.hpp"
#include "app/documents/tolerance_catalogue.hpp"
#include "app/kinds/cam/kind.hpp"
#include "problems/cam/keys.hpp"
#include "problems/cam/motion_laws.hpp"

namespace cognate::app {
namespace {

using cam::MotionLaw;

constexpr Entry kTranslatingRoller[] = {
    {"base_radius", "of the prime circle: minimum distance of the roller's centre from the cam's"},
    {"offset",
     "of the follower's line from the cam's centre; positive helps the rise; 0 with constant "
     "breadth"},
    {"roller_radius", "in [mechanism] or [follower]"}};
constexpr Entry kTranslatingFlat[] = {
    {"base_radius", "minimum distance of the face from the cam's centre"},
    {"offset", "of the follower's line, without effect on the cam (default 0)"}};
constexpr Entry kTranslatingKnife[] = {
    {"base_radius", "minimum distance of the edge from the cam's centre"},
    {"offset", "of the follower's line from the cam's centre; positive helps the rise"}};
constexpr Entry kOscillatingRoller[] = {
    {"base_radius", "of the prime circle: minimum distance of the roller's centre from the cam's"},
    {"centre_distance", "of the follower's pivot from the cam's centre"},
    {"arm", "from the pivot to the roller's centre; in [mechanism] or [follower]"},
    {"roller_radius", "in [mechanism] or [follower]"}};
constexpr Entry kOscillatingFlat[] = {
    {"base_radius", "minimum distance of the face from the cam's centre"},
    {"centre_distance", "of the follower's pivot from the cam's centre"},
    {"face_offset", "by how much the face lies nearer to the cam than its pivot (default 0)"}};
constexpr Entry kOscillatingKnife[] = {
    {"base_radius", "minimum distance of the edge from the cam's centre"},
    {"centre_distance", "of the follower's pivot from the cam's centre"},
    {"arm", "from the pivot to the edge; in [mechanism] or [follower]"}};

constexpr KeyedEntry kFollowers[] = {
    {"translating-roller", "a roller on a slide", kTranslatingRoller},
    {"translating-flat", "a face square to its slide", kTranslatingFlat},
    {"translating-knife", "an edge on a slide", kTranslatingKnife},
    {"oscillating-roller", "a roller on a swinging arm", kOscillatingRoller},
    {"oscillating-flat", "a swinging face", kOscillatingFlat},
    {"oscillating-knife", "an edge on a swinging arm", kOscillatingKnife}};

constexpr Entry kFollower[] = {
    {"type", "one of the followers above"},
    {"side", "oscillating: \"trailing\" (default) or \"leading\""},
    {"closure",
     "\"force\" (default), \"groove\", \"conjugate\" (rollers) or \"constant-breadth\" "
     "(translating)"},
    {"breadth",
     "translating conjugate and constant-breadth: between both contacts; free if left "
     "out"},
    {"arms_deg", "oscillating conjugate: angle between the arms"},
    {"mass", "translating; inertia: oscillating, about the pivot; with drive.speed"},
    {"spring_rate", "by length, or by radian of an oscillating follower"},
    {"preload",
     "of the spring at displacement 0; by default the minimum that keeps contact; required "
     "if angles or shares of the motion are free and forces limited or minimised"},
    {"load", "constant, against the rise: a force, or a moment about the pivot"}};

constexpr Entry kMotion[] = {
    {"law", "one of the motion laws below"},
    {"over_deg", "of the cam; [min, max]: free within. All add up to 360"},
    {"rise", "translating; rise_deg: oscillating; negative in a return, none in a dwell"},
    {"sine, constant, cosine",
     "universal: shares of the acceleration's course, 1 together at most, the rest at constant "
     "velocity; [min, max]: free within"},
    {"conditions",
     "polynomial: [{at_deg, displacement | velocity | acceleration | jerk}, ...], with both ends "
     "16 at most; derivatives by the cam's angle in radians; displacement_deg: oscillating"},
    {"points",
     "spline: [[at_deg, displacement], ...] inside, displacement in degrees: oscillating"},
    {"degree", "spline: 3 or 5 (default)"},
    {"velocity", "spline: [begin, end] (default 0), acceleration: likewise, of degree 5"},
    {"periodic", "spline of a whole turn: true: its ends join smoothly"}};

constexpr Entry kMechanism[] = {
    {"base_radius, offset, roller_radius, centre_distance, arm, face_offset",
     "of the follower's type; what is left out is found"},
    {"rotation", "\"ccw\" (default) or \"cw\""}};

constexpr Entry kBounds[] = {
    {"base_radius, offset, roller_radius, centre_distance, arm, face_offset",
     "[min, max]; inf leaves a side open"}};

constexpr Entry kTarget[] = {
    {"objective",
     "what is minimised: \"size\" (the base radius, default), \"pressure-angle\", "
     "\"contact-force\", "
     "\"torque\" or \"contact-stress\"; of conjugate cams neither contact force nor stress"}};

constexpr Entry kUndercut[] = {
    {"curvature_radius_min", "of the profile where it is convex (default 0)"},
    {"no_undercut", "true (default); false allows it, without curvature_radius_min"}};

constexpr Entry kSeparation[] = {
    {"no_separation", "true (default): the follower never lifts off; force closure"}};

constexpr Entry kDrive[] = {
    {"speed", "of the cam, constant, rad/s; or speed_rpm, in turns a minute"}};

constexpr Entry kContact[] = {{"width", "of the line of contact"},
                              {"elasticity", "[E1, E2] of cam and follower"},
                              {"poisson", "[nu1, nu2] (default 0.3 each)"}};

constexpr auto kConstraints = entries_of(problems::reading::kPressureAngleKeys, kUndercut,
                                         problems::reading::kProfileKeys, kSeparation);

constexpr Entry kSolve[] = {{"solver, starts, tolerance", "as below; no solver for least squares"},
                            {"designs", "1 to 100 (default 1)"}};

constexpr KeyedEntry kTables[] = {
    {"[follower]", "what the cam moves", kFollower},
    {"[[motion]]", "a segment, in the order of the turn, from the base circle", kMotion},
    {"[mechanism]", "its lengths", kMechanism},
    {"[bounds]", "of lengths", kBounds},
    {"[target]", "what is sought", kTarget},
    {"[constraints]", "on the cam", kConstraints},
    {"[drive]", "how it runs", kDrive},
    {"[contact]", "materials, for contact stress", kContact},
    {"[solve]", "how it is found", kSolve},
    {"[tolerance]", kToleranceMeaning, kToleranceEntries}};

constexpr Metric kCamMetrics[] = {
    {"stroke", "length", "maximum displacement of a translating follower"},
    {"swing_deg", "deg", "of an oscillating one"},
    {"pressure_angle_deg_max", "deg", "maximum of either sign"},
    {"pressure_angle_deg_max_rise", "deg", "in the rises, of either sign"},
    {"pressure_angle_deg_max_return", "deg", "in the returns, of either sign"},
    {"pressure_angle_deg_max_rise_working", "deg",
     "in the rises, on the side to which the cam pushes"},
    {"pressure_angle_deg_max_return_working", "deg", "in the returns, on the other side"},
    {"prime_radius", "length", "of the prime circle, on which the pitch curve of a roller begins"},
    {"base_radius", "length", "of the base circle, on which the profile begins"},
    {"curvature_radius_min", "length", "of the profile where it is convex; negative: undercut"},
    {"concave_radius_min", "length", "of the profile where it is concave"},
    {"undercut", "boolean", "whether the profile cannot guide its follower everywhere"},
    {"profile_radius_min, profile_radius_max", "length", "distance of the profile from the centre"},
    {"face_width", "length", "of a flat face that the contact passes over"},
    {"breadth", "length", "of parallel contacts, constant"},
    {"second_cam_prime_radius, second_cam_base_radius", "length",
     "of the other cam of a conjugate pair"},
    {"second_cam_pressure_angle_deg_max", "deg", "of that cam"},
    {"second_cam_curvature_radius_min", "length", "of that cam"},
    {"second_cam_contact_force_max", "N", "of that cam, which takes what the first cannot"},
    {"second_cam_contact_stress_max", "Pa", "of that cam"},
    {"roller_speed_max", "rad/s", "of the roller about its axis, as seen from the follower"},
    {"roller_speed_ratio_max", "1", "the same over the cam's speed, where none is given"},
    {"follower_velocity_max", "length/s or rad/s", "at the cam's speed"},
    {"follower_acceleration_max", "length/s² or rad/s²", "at the cam's speed"},
    {"follower_jerk_max", "length/s³ or rad/s³", "at the cam's speed"},
    {"preload", "N or N·m", "of the follower: given, or the minimum that keeps contact"},
    {"preload_min", "N or N·m", "the minimum that keeps contact"},
    {"demand_min", "N or N·m", "minimum push along the motion; negative: lifts off"},
    {"contact_force_max", "N", "along the normal"},
    {"torque_max", "N·m", "that drives the cam, the maximum of either sense"},
    {"contact_stress_max", "Pa", "Hertzian pressure of the line contact"},
    {"..._at_deg", "deg", "of an extreme NAME, as NAME_at_deg: the cam angle where it is"}};

/// A motion law and the greatest velocity, acceleration and jerk of a rise of 1 over a cam angle of
/// 1, computed from the law itself and as handbooks print them; infinite where acceleration jumps.
/// Laws with parameters have no factors of their own.
struct MotionLawEntry {
  std::string_view name;
  std::string_view meaning;
  std::string_view vdi_name;
  std::optional<cam::PeakFactors> factors;
  std::optional<cam::PeakFactors> handbook;
};

std::vector<MotionLawEntry> motion_laws() {
  std::vector<MotionLawEntry> all;
  for (const auto& [law, word, meaning, has_parameters, vdi_name] : problems::kMotionLaws) {
    MotionLawEntry entry{word, meaning, vdi_name, std::nullopt, cam::handbook_factors(law)};
    if (law == MotionLaw::dwell) {
      entry.handbook.reset();
    } else if (!has_parameters) {
      entry.factors = cam::peak_factors({.law = law, .over = 1, .rise = 1});
    }
    all.push_back(entry);
  }
  return all;
}

std::string factor(double value) {
  return std::isfinite(value) ? fmt::format("{:.5g}", value) : "inf";
}

/// A computed factor, and in brackets the handbook's; nothing where the law has parameters.
std::string factors(const MotionLawEntry& law, double cam::PeakFactors::*of) {
  std::string text = law.factors ? factor((*law.factors).*of) : "";
  if (law.handbook) text += fmt::format(" ({})", factor((*law.handbook).*of));
  return text;
}

std::string motion_law_text() {
  Column names{"  law", Align::left, {}};
  Column velocity{"velocity C_v", Align::right, {}},
      acceleration{"acceleration C_a", Align::right, {}}, jerk{"jerk C_j", Align::right, {}},
      vdi_names{"VDI 2143", Align::left, {}}, meanings{"", Align::left, {}};
  for (const auto& law : motion_laws()) {
    names.cells.push_back("  " + std::string(law.name));
    velocity.cells.push_back(factors(law, &cam::PeakFactors::velocity));
    acceleration.cells.push_back(factors(law, &cam::PeakFactors::acceleration));
    jerk.cells.push_back(factors(law, &cam::PeakFactors::jerk));
    vdi_names.cells.emplace_back(law.vdi_name);
    meanings.cells.emplace_back(law.meaning);
  }
  std::string text =
      "motion laws of cams (motion.law = ...): greatest values for a rise of 1 over a cam angle of "
      "1,"
      " in brackets\nthose that handbooks print\n";
  for (const auto& line : set_columns({names, velocity, acceleration, jerk, vdi_names, meanings})) {
    text += line + '\n';
  }
  return text;
}

/// Infinity has no JSON number: null.
nlohmann::ordered_json peak_factors_json(const std::optional<cam::PeakFactors>& factors) {
  if (!factors) return nullptr;
  const auto number = [](double x) {
    return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json();
  };
  return {{"velocity", number(factors->velocity)},
          {"acceleration", number(factors->acceleration)},
          {"jerk", number(factors->jerk)}};
}

nlohmann::ordered_json motion_laws_json() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& law : motion_laws()) {
    rows.push_back({{"name", law.name},
                    {"meaning", law.meaning},
                    {"peak_factors", peak_factors_json(law.factors)},
                    {"handbook", peak_factors_json(law.handbook)}});
    if (!law.vdi_name.empty()) rows.back()["vdi_2143"] = law.vdi_name;
  }
  return rows;
}

}  // namespace

std::span<const KeyedEntry> cam_followers() {
  return kFollowers;
}

std::span<const Metric> cam_metrics() {
  return kCamMetrics;
}

std::vector<ListSection> Kind<problems::CamProblem>::sections() {
  return {list_section("cam_followers",
                       "followers of cams (follower.type = ...) and their lengths in [mechanism]",
                       kFollowers),
          list_section("cam_tables", "tables of a cam", kTables),
          {"motion_laws", motion_law_text(), motion_laws_json()}};
}

std::vector<MetricList> Kind<problems::CamProblem>::metric_lists() {
  return {{"cam_metrics", "metric of a cam", kCamMetrics}};
}

}  // namespace cognate::app
