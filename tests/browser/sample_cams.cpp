#include "tests/browser/sample_cams.hpp"

#include <cmath>

#include "analysis/cam/contact.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

using cam::Closure;
using cam::FollowerType;
using cam::MotionLaw;
using cam::MotionSegment;

std::vector<MotionSegment> motion(MotionLaw rising, MotionLaw falling, double rise) {
  return {{.law = rising, .over = 100 * kDegree, .rise = rise},
          {.law = MotionLaw::dwell, .over = 60 * kDegree},
          {.law = falling, .over = 90 * kDegree, .rise = -rise},
          {.law = MotionLaw::dwell, .over = 110 * kDegree}};
}

cam::Cam cam_of(const cam::CamFollower<double>& follower, const std::vector<MotionSegment>& motion,
                const cam::Operation& operation) {
  return {{follower, starting_place(follower), operation}, *programme_of(motion)};
}

/// A cam as a file gives it, all dimensions known, with facts as a solver would report them.
SampleCam sample(std::string name, const cam::CamFollower<double>& follower,
                 const std::vector<MotionSegment>& motion) {
  SampleCam sample{.name = std::move(name), .problem = {}, .result = {}};
  CamProblem& problem = sample.problem;
  problem.title = "Sample: " + sample.name;
  problem.follower = follower.type;
  problem.motion = motion;
  problem.constraints.pressure_angle_max_rise = 35 * kDegree;
  problem.constraints.pressure_angle_max_return = 60 * kDegree;
  CamDesign design{.cam = cam_of(follower, motion, problem.operation), .motion = motion};
  design.metrics = {{"profile_radius_min", 30.0},
                    {"pressure_angle_deg_max_rise", 38.71},
                    {"pressure_angle_deg_max_rise_at_deg", 50.0}};
  design.constraints = {
      {.name = "pressure_angle_deg_max_rise", .value = 38.71, .bound = 35.0, .satisfied = false},
      {.name = "pressure_angle_deg_max_return", .value = 52.16, .bound = 60.0}};
  design.origin = "given";
  CamResult& result = sample.result;
  result.status = Status::solved;
  result.jumps = jumps(design.cam.programme);
  for (const MotionSegment& segment : motion) {
    result.segments.push_back({peak_factors(segment), handbook_factors(segment.law)});
  }
  result.designs = {design};
  return sample;
}

void run(SampleCam& sample, bool with_stress) {
  sample.problem.has_operation = true;
  sample.problem.has_contact = with_stress;
  sample.result.designs[0].operation = {.speed = 30,
                                        .inertia = 0.8,
                                        .spring_rate = 12,
                                        .preload = 90,
                                        .load = 20,
                                        .width = 12,
                                        .modulus_sum = 8.7e-6};
}

SampleCam translating_roller() {
  auto cam = sample("translating-roller",
                    {FollowerType::translating_roller,
                     cam::ArmSide::trailing,
                     {.base_radius = 40, .offset = 15, .roller_radius = 10}},
                    motion(MotionLaw::constant_acceleration, MotionLaw::harmonic, 60));
  run(cam, true);
  cam.result.designs[0].proof =
      SizeProof{38.2, {{50 * kDegree, "pressure_angle_deg_max_rise", 35}}};
  cam.result.notes = {"The acceleration jumps at five cam angles."};
  CamDesign other = cam.result.designs[0];
  other.cam.system.follower.dimensions.base_radius = 70;
  other.cam.system.start = starting_place(other.cam.system.follower);
  for (ConstraintCheck& check : other.constraints) check.satisfied = true;
  cam.result.designs.push_back(other);
  return cam;
}

SampleCam conjugate() {
  const auto smooth = motion(MotionLaw::cycloidal, MotionLaw::modified_sine, 25);
  auto cam = sample("conjugate",
                    {FollowerType::translating_roller,
                     cam::ArmSide::trailing,
                     {.base_radius = 60, .offset = 0, .roller_radius = 12}},
                    smooth);
  cam.problem.second.closure = Closure::conjugate;
  auto turned = smooth;
  for (MotionSegment& segment : turned) segment.rise = -segment.rise;
  cam.result.designs[0].second = cam_of({FollowerType::translating_roller,
                                         cam::ArmSide::trailing,
                                         {.base_radius = 85, .roller_radius = 12}},
                                        turned, {});
  return cam;
}

/// A face kept in contact on both sides: s(δ) + s(δ + 180°) is constant.
SampleCam constant_breadth() {
  auto cam = sample("constant-breadth",
                    {FollowerType::translating_flat, cam::ArmSide::trailing, {.base_radius = 40}},
                    {{.law = MotionLaw::cycloidal, .over = 180 * kDegree, .rise = 15},
                     {.law = MotionLaw::cycloidal, .over = 180 * kDegree, .rise = -15}});
  cam.problem.second.closure = Closure::constant_breadth;
  return cam;
}

}  // namespace

std::vector<SampleCam> sample_cams() {
  using cam::ArmSide;
  const auto smooth = [](double rise) {
    return motion(MotionLaw::polynomial_345, MotionLaw::modified_trapezoid, rise);
  };
  std::vector<SampleCam> cams;
  cams.push_back(translating_roller());
  cams.push_back(sample("translating-flat",
                        {FollowerType::translating_flat, ArmSide::trailing, {.base_radius = 45}},
                        smooth(20)));
  cams.push_back(sample(
      "translating-knife",
      {FollowerType::translating_knife, ArmSide::trailing, {.base_radius = 40, .offset = 10}},
      smooth(30)));
  cams.push_back(
      sample("oscillating-roller",
             {FollowerType::oscillating_roller,
              ArmSide::trailing,
              {.base_radius = 40, .roller_radius = 10, .centre_distance = 110, .arm = 95}},
             smooth(25 * kDegree)));
  cams.push_back(sample("oscillating-flat",
                        {FollowerType::oscillating_flat,
                         ArmSide::leading,
                         {.base_radius = 40, .centre_distance = 110, .face_offset = 12}},
                        smooth(12 * kDegree)));
  cams.push_back(sample("oscillating-knife",
                        {FollowerType::oscillating_knife,
                         ArmSide::leading,
                         {.base_radius = 40, .centre_distance = 110, .arm = 95}},
                        smooth(25 * kDegree)));
  cams.push_back(sample("groove",
                        {FollowerType::translating_roller,
                         ArmSide::trailing,
                         {.base_radius = 55, .offset = 8, .roller_radius = 9}},
                        smooth(30)));
  cams.back().problem.second.closure = Closure::groove;
  cams.back().problem.clockwise = true;
  cams.push_back(conjugate());
  cams.push_back(constant_breadth());
  return cams;
}

}  // namespace cognate::problems
