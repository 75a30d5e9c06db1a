/// @file The curves of a cam and what its follower does round the turn, as a page draws them.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "analysis/cam/cam.hpp"
#include "analysis/cam/turn_extremes.hpp"
#include "problems/cam/problem.hpp"

namespace cognate::app {

/// Places of `programme` in order of the cam angle, from 0 to a whole turn: `steps` equal steps
/// and, unless there are very many pieces, both sides of each piece's border.
std::vector<cam::TurnPlace> cam_places(const cam::MotionProgramme& programme, std::size_t steps);

/// A stretch of the cam angle, rad, with one sense of motion.
struct CamStroke {
  double from = 0;
  double to = 0;
  cam::Stroke stroke = cam::Stroke::dwell;
};

/// The strokes of `programme` in order, neighbours of one sense joined.
std::vector<CamStroke> cam_strokes(const cam::MotionProgramme& programme);

/// How finely each design of a page is drawn.
struct CamFineness {
  std::size_t steps = 720;    ///< of the table round the turn
  std::size_t points = 1500;  ///< of each curve at most
};

/// Fineness with which the data of `designs` designs stay below about a megabyte.
CamFineness cam_fineness(std::size_t designs);

/// The curve at `distance` outside the pitch curve (of a flat face: the profile) in the cam's own
/// axes: `deg` (cam angles), `x`, `y`, `curvature` (null where it is not finite).
nlohmann::ordered_json curve_json(const cam::Cam& cam, double distance,
                                  const CamFineness& fineness);

/// A cam: `side` (+1 for a trailing arm), `dimensions`, `start` (the follower's place at
/// displacement 0, angles in rad), `profile`, `pitch` (null for flat faces), and `table`: a list of
/// values for `deg` and for each quantity that there is, the contact and the common normal there in
/// the frame's axes.
nlohmann::ordered_json cam_json(const cam::Cam& cam, const problems::CamProblem& problem,
                                const cam::Operation& operation, const CamFineness& fineness);

}  // namespace cognate::app
