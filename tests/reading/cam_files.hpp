/// @file Files of cams, by their parts.
#pragma once

#include <string>

namespace cognate::problems::cam_files {

inline const std::string kRise = "{law = \"harmonic\", over_deg = 120, rise = 20}";
inline const std::string kReturn = "{law = \"3-4-5\", over_deg = 150, rise = -20}";
inline const std::string kDwell = "{law = \"dwell\", over_deg = 90}";
inline const std::string kTurn = "motion = [" + kRise + ", " + kReturn + ", " + kDwell + "]\n";

// `lines` begins with keys of [follower]; the first of them is line 6.
inline std::string file(const std::string& type, const std::string& lengths,
                        const std::string& lines) {
  return "kind = \"cam\"\n" + kTurn + "mechanism = {" + lengths + "}\n[follower]\ntype = \"" +
         type + "\"\n" + lines;
}

inline const std::string kGiven = "base_radius = 40, offset = 5, roller_radius = 8";

inline std::string roller(const std::string& lines) {
  return file("translating-roller", kGiven, lines);
}

// The same with a motion of degrees.
inline std::string swinging(const std::string& type, const std::string& lengths,
                            const std::string& lines) {
  return "kind = \"cam\"\nmotion = [{law = \"harmonic\", over_deg = 180, rise_deg = 25}, {law = "
         "\"cycloidal\", over_deg = 180, rise_deg = -25}]\nmechanism = {" +
         lengths + "}\n[follower]\ntype = \"" + type + "\"\n" + lines;
}

inline const std::string kArm =
    "base_radius = 25, centre_distance = 60, arm = 50, roller_radius = 8";

inline const std::string kEdge = "base_radius = 25, centre_distance = 60, arm = 50";

inline std::string with_motion(const std::string& motion) {
  return "kind = \"cam\"\nmotion = " + motion + "\nmechanism = {" + kGiven +
         "}\nfollower.type = \"translating-roller\"\n";
}

inline std::string segments(const std::string& first) {
  return "[" + first + ",\n" + kReturn + ",\n" + kDwell + "]";
}

// A roller's motion with two free angles; `lines` begins with keys of [follower], as in `file`.
inline std::string free_motion(const std::string& lines) {
  return "kind = \"cam\"\nmotion = [{law = \"cycloid\", over_deg = [80, 280], rise = 20}, {law = "
         "\"cycloid\", over_deg = [80, 280], rise = -20}]\nmechanism = {" +
         kGiven + "}\n[follower]\ntype = \"translating-roller\"\n" + lines;
}

}  // namespace cognate::problems::cam_files
