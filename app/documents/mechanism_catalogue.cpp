#include "app/documents/mechanism_catalogue.hpp"

#include <array>
#include <vector>

#include "app/documents/layers_catalogue.hpp"
#include "app/documents/tolerance_catalogue.hpp"
#include "problems/mechanism/mechanism_types.hpp"

namespace cognate::app {
namespace {

template <class Type>
constexpr auto kKeysOf = entries_of(problems::TypeTraits<Type>::kKeys);

template <>
constexpr std::array<Entry, 4> kKeysOf<problems::ChainDescription> = {
    {{"[[pivot]]", "points of the frame"},
     {"[crank] or [slider]", "what drives"},
     {"[[dyad]]", "pairs of bodies, each joined to what is there before"},
     {"output", "the body whose motion is the output (default: the last)"}}};

std::vector<KeyedEntry> all_mechanisms() {
  std::vector<KeyedEntry> all;
  problems::for_each_mechanism_type([&]<class Type>(std::type_identity<Type>) {
    using Traits = problems::TypeTraits<Type>;
    all.push_back({Traits::kWord, Traits::kMeaning, kKeysOf<Type>});
  });
  return all;
}

constexpr Entry kSlide{"slide", "{through = point or [x, y], direction_deg, offset, on = body}"};
constexpr Entry kNew{"new", "name of the joint between its two bodies"};

constexpr Entry kRrr[] = {{"joins", "two points"},
                          {"lengths", "[l1, l2] from these to the new point"},
                          {"assembly", "\"open\" (default): new to the left of first to second"},
                          kNew};
constexpr Entry kRrp[] = {{"joins", "a point"},
                          {"length", "from it to the slider's pin"},
                          kSlide,
                          {"assembly", "\"open\" (default): the pin ahead of the point"},
                          kNew};
constexpr Entry kRpr[] = {{"joins", "[the block's point, the bar's pivot]"},
                          {"offset", "of the bar from its pivot (default 0)"},
                          {"assembly", "\"open\" (default): the block ahead of the pivot"}};
constexpr Entry kPrp[] = {{"slides", "two tables, each as slide"}, kNew};
constexpr Entry kRpp[] = {{"joins", "a point, of the block"},
                          kSlide,
                          {"slot_deg", "of the slot from the slide (default 90)"},
                          {"new", "name of the point where slot and slide cross"}};

constexpr Entry kGroup[] = {
    {"names", "of its bodies, an even number from 4 to 16"},
    {"at", "[x, y] of each body's axes, as they stand at drive_deg"},
    {"direction_deg", "of each body's first axis there"},
    {"drive_deg", "the drive's position there; of a driving slider drive"},
    {"joint",
     "[[dyad.joint]], three for two bodies: {name, of = two bodies, at = [x, y] on each}; "
     "of a slide direction_deg = [on the first, on the second]"}};

/// With the names of VDI 2729, D a hinge and S a slide.
constexpr KeyedEntry kDyads[] = {
    {"RRR", "two links and three hinges (VDI 2729: DDD)", kRrr},
    {"RRP", "a link and a slider (DDS)", kRrp},
    {"RPR", "a block that slides on a turning bar (DSD)", kRpr},
    {"PRP", "two sliders with a common pin (SDS)", kPrp},
    {"RPP", "a block in the slot of a slider (DSS)", kRpp},
    {"group", "more bodies that close together (class III, IV…)", kGroup}};

constexpr Entry kJointTable[] = {
    {"name", "the joint's name"},
    {"of", "links it joins, \"frame\" the fixed one: of a pin two or more, of a point one"},
    {"at", "[x, y] where it is drawn"},
    {"direction_deg", "of a slide of two links, instead of at"}};

constexpr Entry kPivotTable[] = {{"name", "of the point"}, {"at", "[x, y]"}};
constexpr Entry kCrankTable[] = {{"at", "the pivot it turns about"},
                                 {"pin", "name of its other end"},
                                 {"length", "between them"},
                                 {"name", "of the body (default \"crank\")"}};
constexpr Entry kSliderTable[] = {
    kSlide, {"pin", "name of its point"}, {"name", "of the body (default \"slider\")"}};
constexpr Entry kCylinderTable[] = {
    {"at", "the pivot of the cylinder"},
    {"about", "the pivot of the link that it turns"},
    {"pin", "name of the pin that joins the rod to the link"},
    {"length", "of the link, from its pivot to the pin"},
    {"assembly", "\"open\" (default): the pin to the left of at to about"},
    {"names", "of rod, cylinder and link (default \"rod\", \"cylinder\", both ends of the link)"}};
constexpr Entry kPointTable[] = {
    {"name", "of the point"},
    {"on", "a body, or two of its points: origin, and where the first axis points"},
    {"at", "[u, v]"}};
constexpr Entry kLinkTable[] = {
    {"between", "two points of the body: origin, and where the first axis points"},
    {"name", "or: of the body, whose own axes are meant"},
    {"mass", "kg"},
    {"centre", "[u, v] of mass"},
    {"inertia", "kg m2, about the centre of mass"}};
constexpr Entry kLoadTable[] = {
    {"on", "a point, a body, or two points of one"},
    {"at", "[u, v], for a body or two points (default [0, 0])"},
    {"force", "[fx, fy] in N, global axes"},
    {"torque", "N m, counter-clockwise"},
    {"when", "\"always\" (default), \"advance\", \"return\", or [from_deg, to_deg] of the crank"},
    {"stroke", "[from, to], the part of the body's stroke in which it acts (0 to 1)"}};
constexpr Entry kDriveTable[] = {
    {"speed",
     "rad/s, or length/s of a slider or a cylinder (default 1); or speed_rpm, in turns a minute"},
    {"acceleration", "rad/s2, or length/s2 (default 0)"},
    {"start_deg, end_deg",
     "of the crank (default 0 and a turn more); start, end of a slider or of a cylinder's length"},
    {"steps", "between them, both included (default 360)"}};
constexpr Entry kOutputTable[] = {
    {"want", "a list of these quantities and of points"},
    {"position, velocity, acceleration, transmission", "true by default"},
    {"curvature", "of the points' paths; cusps, inflections, double points (default false)"},
    {"instant_geometry", "bodies whose poles, inflection circles and Ball's points are computed"},
    {"curve", "length, area, widths... of a four-bar's coupler curve, as metrics (default false)"},
    {"cognates", "Roberts' cognates of a four-bar with a coupler point (default false)"},
    {"foot", "point whose gait is measured: duty factor, stride, step height, flatness, speeds"},
    {"duty", "its duty factor (default: the foot stands within 15 % of the step height)"},
    {"reactions, torque", "true by default where there are masses or loads"},
    {"points", "names of those to report (default: all that move)"}};

constexpr KeyedEntry kAnalysisTables[] = {
    {"[[joint]]", "of a chain as drawn, with driven = a link: instead of pivots, drive and dyads",
     kJointTable},
    {"[[pivot]]", "of a chain: a point of the frame", kPivotTable},
    {"[crank]", "of a chain: what drives", kCrankTable},
    {"[slider]", "of a chain: what drives instead of a crank", kSliderTable},
    {"[cylinder]", "of a chain: what drives by its length instead of a crank", kCylinderTable},
    {"[[point]]", "a further point of a body", kPointTable},
    {"[[link]]", "mass and inertia of a body", kLinkTable},
    {"[[load]]", "a force or a torque on a body", kLoadTable},
    {"gravity", "[gx, gy] in length/s2 (default [0, 0]); a key, not a table", {}},
    {"[drive]", "how the crank, or the driving slider, moves", kDriveTable},
    {"[output]", "what is computed; the rest is skipped", kOutputTable},
    {"[tolerance]", kToleranceMeaning, kToleranceEntries},
    {"[layers]", problems::reading::kLayersMeaning, kLayersEntries}};

}  // namespace

std::span<const KeyedEntry> mechanisms() {
  static const auto all = all_mechanisms();
  return all;
}

std::span<const KeyedEntry> dyads() {
  return kDyads;
}

std::span<const KeyedEntry> analysis_tables() {
  return kAnalysisTables;
}

}  // namespace cognate::app
