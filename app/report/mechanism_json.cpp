#include "app/report/mechanism_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "app/drawing/mechanism_poses.hpp"
#include "app/drawing/mechanism_shapes.hpp"
#include "app/report/drawn_number.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::AnalysisProblem;
using problems::DriveSpan;
using problems::DriveSweep;
using problems::NamedMechanism;

/// Samples of a motion, and numbers that all bodies' samples together may be.
constexpr int kFewestSamples = 121, kMostSamples = 721, kNumbers = 45'000;

int sample_count(const AnalysisProblem& problem) {
  const int bodies = body_count(problem.mechanism.mechanism);
  return std::clamp(kNumbers / (3 * bodies), kFewestSamples, kMostSamples);
}

ordered_json vector_json(const Vec2d& v) {
  return {drawn(v.x), drawn(v.y)};
}

/// `values` in `unit`s: one number where they are all the same to the digits drawn.
ordered_json track_json(const std::vector<double>& values, double unit) {
  ordered_json list = ordered_json::array();
  for (const double value : values) list.push_back(drawn(unit * value));
  const bool constant = std::ranges::all_of(list, [&](const auto& v) { return v == list.front(); });
  return constant && !list.empty() ? list.front() : list;
}

ordered_json shape_json(const BodyShape& shape) {
  ordered_json outline = ordered_json::array(), rails = outline;
  for (const Vec2d& corner : shape.outline) outline.push_back(vector_json(corner));
  for (const Rail& rail : shape.rails)
    rails.push_back({vector_json(rail.from), vector_json(rail.to)});
  return {{"outline", outline}, {"rails", rails}, {"block", shape.block}};
}

std::string body_name(const NamedMechanism& mechanism, std::size_t body) {
  return body < mechanism.bodies.size() ? mechanism.bodies[body] : "body " + std::to_string(body);
}

ordered_json bodies_json(const NamedMechanism& mechanism, const MechanismPoses& poses,
                         const MechanismShapes& shapes) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < poses.bodies.size(); ++i) {
    ordered_json body = {{"name", body_name(mechanism, i)},
                         {"x", track_json(poses.bodies[i].x, 1)},
                         {"y", track_json(poses.bodies[i].y, 1)},
                         {"deg", track_json(poses.bodies[i].angle, kDegreesInRadian)}};
    body.update(shape_json(shapes.bodies[i]));
    list.push_back(body);
  }
  return list;
}

ordered_json place_json(const Attached<double>& place) {
  return {{"body", place.body}, {"at", vector_json(place.at)}};
}

ordered_json pins_json(const MechanismShapes& shapes) {
  ordered_json list = ordered_json::array();
  for (const Pin& pin : shapes.pins) {
    ordered_json entry = place_json(pin.at);
    entry["fixed"] = pin.fixed;
    list.push_back(entry);
  }
  return list;
}

ordered_json points_json(const NamedMechanism& mechanism) {
  ordered_json list = ordered_json::array();
  for (const auto& point : mechanism.points) {
    ordered_json entry = place_json(point.at);
    entry["name"] = point.name;
    list.push_back(entry);
  }
  return list;
}

}  // namespace

double drive_unit(const NamedMechanism& mechanism) {
  return driven_by_length(mechanism.mechanism.drive) ? 1 : kDegreesInRadian;
}

ordered_json mechanism_motion_json(const NamedMechanism& mechanism, const DriveSpan& span,
                                   int samples) {
  const auto poses = sample_poses(mechanism.mechanism, span.from, span.to, samples);
  const auto shapes = mechanism_shapes(mechanism, poses);
  const double unit = drive_unit(mechanism);
  ordered_json drive = ordered_json::array();
  for (const double coordinate : poses.drive) drive.push_back(drawn(unit * coordinate));
  return {{"drive", drive},
          {"output", mechanism.output},
          {"bodies", bodies_json(mechanism, poses, shapes)},
          {"pins", pins_json(shapes)},
          {"points", points_json(mechanism)}};
}

ordered_json mechanism_json(const AnalysisProblem& problem) {
  const DriveSweep& sweep = problem.drive;
  return mechanism_motion_json(problem.mechanism, {sweep.start, sweep.end}, sample_count(problem));
}

ordered_json drive_json(const NamedMechanism& mechanism, const DriveSpan& span) {
  const bool slides = driven_by_length(mechanism.mechanism.drive);
  const double unit = drive_unit(mechanism);
  return {{"name", mechanism.bodies.size() > 1 ? mechanism.bodies[1] : "drive"},
          {"kind", slides ? "slider" : "angle"},
          {"from", unit * span.from},
          {"to", unit * span.to},
          {"round", span.round}};
}

}  // namespace cognate::app
