/// @file The keys of gear trains.
#pragma once

#include "problems/toml/keys.hpp"
#include "problems/train/problem.hpp"

namespace cognate::problems::reading {

inline constexpr int kFewestTrainTeeth = 3, kMostTrainTeeth = 10000;
inline constexpr std::size_t kMostMeshes = 60, kMostMembers = 100, kMostStates = 40;
inline constexpr int kMostPlanets = 100, kMostPairs = 4, kMostTrainDesigns = 100;

inline constexpr NumberRule kMeshEfficiency{[](double x) { return x >= 0.01 && x <= 1; },
                                            "a number from 0.01 to 1"};
inline constexpr NumberRule kTrainModule{[](double x) { return x >= 1e-6 && x <= 1e6; },
                                         "a length from 1e-6 to 1e6"};
inline constexpr NumberRule kTrainLoad{
    [](double x) { return x == 0 || (x >= 1e-12 && x <= 1e12) || (x <= -1e-12 && x >= -1e12); },
    "a number, 0 or of magnitude 1e-12 to 1e12,"};
inline constexpr NumberRule kTrainSpeed{
    [](double x) { return x == 0 || (x >= 1e-9 && x <= 1e9) || (x <= -1e-9 && x >= -1e9); },
    "a speed, 0 or of magnitude 1e-9 to 1e9,"};
inline constexpr NumberRule kTrainInertia{
    [](double x) { return x == 0 || (x >= 1e-12 && x <= 1e12); },
    "0 or a number from 1e-12 to 1e12"};
inline constexpr NumberRule kTrainRatio{
    [](double x) { return (x >= 1e-9 && x <= 1e9) || (x <= -1e-9 && x >= -1e9); },
    "a ratio of magnitude 1e-9 to 1e9"};
inline constexpr NumberRule kTrainTolerance{[](double x) { return x >= 0 && x <= 0.5; },
                                            "a number from 0 to 0.5"};

inline constexpr Key<TrainMesh> kTrainMeshKeys[] = {
    own_key<TrainMesh>("gears", "[\"a\", \"b\"], the members that it joins"),
    own_key<TrainMesh>("teeth", "[za, zb], 3 to 10000 each; of internal teeth the greater number"),
    key<&TrainMesh::type>("type",
                          "\"external\" (default), \"internal\", \"bevel\" (turning against each "
                          "other in the frame of their carrier) or \"bevel-alike\""),
    key<&TrainMesh::efficiency>("efficiency",
                                "of the power passed in the frame of its carrier (default 1)",
                                kMeshEfficiency),
    key<&TrainMesh::module>("module", "for distances (default 1 where no mesh has one)",
                            kTrainModule)};

inline constexpr Key<TrainPlanet> kTrainPlanetKeys[] = {
    key<&TrainPlanet::name>("name", "of a member in some mesh"),
    key<&TrainPlanet::carrier>("carrier", "the member on which its axis is"),
    key<&TrainPlanet::count>("count", "of equal ones, equally spaced (default 1)",
                             IntegerRule{1, kMostPlanets}),
    key<&TrainPlanet::inertia>("inertia", "of each about its own axis (default 0)", kTrainInertia),
    key<&TrainPlanet::mass>("mass", "of each (default 0); with module in its meshes",
                            kTrainInertia)};

inline constexpr Key<TrainShaft> kTrainShaftKeys[] = {
    key<&TrainShaft::name>("name", "of a member"),
    key<&TrainShaft::inertia>("inertia", "of all that is fast to it (default 0)", kTrainInertia)};

inline constexpr Key<TrainInput> kTrainInputKeys[] = {
    key<&TrainInput::member>("member", "its name"),
    speed_key<&TrainInput::speed>("speed", "rad/s (default 1), or speed_rpm", kTrainSpeed),
    key<&TrainInput::torque>("torque", "that drives it; left out: follows from that of the output",
                             kTrainLoad)};

inline constexpr Key<TrainOutput> kTrainOutputKeys[] = {
    key<&TrainOutput::member>("member", "its name"),
    key<&TrainOutput::torque>("torque", "of the load on it, against the motion where of other sign",
                              kTrainLoad)};

inline constexpr Key<TrainBrake> kTrainBrakeKeys[] = {
    key<&TrainBrake::name>("name", "by which states engage it"),
    key<&TrainBrake::holds>("holds", "the member that it fixes")};

inline constexpr Key<TrainClutch> kTrainClutchKeys[] = {
    key<&TrainClutch::name>("name", "by which states engage it"),
    own_key<TrainClutch>("joins", "[\"a\", \"b\"], the members that it makes one")};

inline constexpr Key<TrainState> kTrainStateKeys[] = {
    key<&TrainState::name>("name", "\"1\", \"reverse\""),
    own_key<TrainState>("engaged", "[\"B1\", \"C1\"], brakes and clutches")};

inline constexpr Key<TrainTarget> kTrainTargetKeys[] = {
    key<&TrainTarget::train>("train", "\"compound\" (default) or \"planetary\""),
    key<&TrainTarget::ratio>(
        "ratio", "input speed over output speed, as \"355/113\"; of a compound train its magnitude",
        kTrainRatio),
    key<&TrainTarget::ratio_tolerance>("ratio_tolerance", "relative (default 0.001)",
                                       kTrainTolerance),
    key<&TrainTarget::objective>(
        "objective",
        "\"error\" of the ratio (default) or \"size\", the sum of all teeth, minimised"),
    key<&TrainTarget::coaxial>("coaxial",
                               "compound of two pairs: both with one sum of teeth (default false)"),
    key<&TrainTarget::input>("input", "planetary: \"sun\" (default), \"ring\" or \"carrier\""),
    key<&TrainTarget::output>("output", "planetary: \"carrier\" (default), \"sun\" or \"ring\"")};

}  // namespace cognate::problems::reading
