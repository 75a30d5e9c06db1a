#include "app/documents/mechanism_catalogue.hpp"

namespace cognate::app {
namespace {

constexpr Entry kPivot{"pivot", "[x, y] of the crank's pivot A (default [0, 0])"};
constexpr Entry kCrank{"crank", "length A-B"};
constexpr Entry kOffset{"offset", "of the slide line from A, positive to its left (default 0)"};
constexpr Entry kDirection{"direction_deg", "of the slide line (default 0)"};

constexpr Entry kFourBar[] = {
    {"fixed_pivots", "[[x, y], [x, y]] of A and D"},
    kCrank,
    {"coupler", "length B-C"},
    {"rocker", "length C-D"},
    {"assembly", "\"open\" (default): C to the left of the line from B to D; or \"crossed\""},
    {"coupler_point", "[u, v] of P: origin B, first axis from B to C"}};

constexpr Entry kSliderCrank[] = {
    kPivot,  kCrank,     {"coupler", "length B-C"},
    kOffset, kDirection, {"assembly", "\"open\" (default): C ahead of B; or \"crossed\""}};

constexpr Entry kGuideBar[] = {
    {"fixed_pivots", "[[x, y], [x, y]] of the crank (A) and of the guide or block (D)"},
    kCrank,
    {"offset", "of the guide line from its pivot, positive to its left (default 0)"},
    {"assembly", "with an offset: \"open\" (default) or \"crossed\""}};

constexpr Entry kScotchYoke[] = {
    kPivot, kCrank, kOffset, kDirection, {"slot_deg", "of the slot from the slide (default 90)"}};

constexpr Entry kTangentGenerator[] = {{"pivot", "[x, y] of the lever's pivot A (default [0, 0])"},
                                       {"offset", "of the slide line from A, positive to its left"},
                                       kDirection};

constexpr Entry kEllipticTrammel[] = {
    {"centre", "[x, y] where the lines cross (default [0, 0])"},
    {"length", "of the link, A-B"},
    {"direction_deg", "of the line of A (default 0)"},
    {"second_line_deg", "of the line of B from that of A (default 90)"}};

constexpr Entry kOldhamCoupling[] = {
    {"fixed_pivots", "[[x, y], [x, y]] of the shafts, A and D"},
    {"slot_deg", "of the second tongue from the first (default 90)"}};

constexpr Entry kChain[] = {{"[[pivot]]", "points of the frame"},
                            {"[crank] or [slider]", "what drives"},
                            {"[[dyad]]", "pairs of bodies, each joined to what is there before"}};

constexpr KeyedEntry kMechanisms[] = {
    {"four-bar", "four links and four hinges: A-B-C-D", kFourBar},
    {"slider-crank", "a crank A-B, a coupler B-C, a slider at C", kSliderCrank},
    {"guide-bar", "a crank whose block slides on a bar that swings or turns", kGuideBar},
    {"oscillating-block", "a crank whose rod slides through a block that swings", kGuideBar},
    {"fixed-block", "a slider-crank stood on its slider: a hand pump", kSliderCrank},
    {"scotch-yoke", "a crank whose pin runs in the slot of a slide", kScotchYoke},
    {"tangent-generator", "a slotted lever moves the pin of a slider", kTangentGenerator},
    {"elliptic-trammel", "a link with both ends on slides", kEllipticTrammel},
    {"oldham-coupling", "two parallel shafts and a disc between them", kOldhamCoupling},
    {"chain", "a drive and any number of dyads", kChain}};

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

constexpr KeyedEntry kDyads[] = {{"RRR", "two links and three hinges", kRrr},
                                 {"RRP", "a link and a slider", kRrp},
                                 {"RPR", "a block that slides on a turning bar", kRpr},
                                 {"PRP", "two sliders with a common pin", kPrp},
                                 {"RPP", "a block in the slot of a slider", kRpp}};

constexpr Entry kPivotTable[] = {{"name", "of the point"}, {"at", "[x, y]"}};
constexpr Entry kCrankTable[] = {{"at", "the pivot it turns about"},
                                 {"pin", "name of its other end"},
                                 {"length", "between them"},
                                 {"name", "of the body (default \"crank\")"}};
constexpr Entry kSliderTable[] = {
    kSlide, {"pin", "name of its point"}, {"name", "of the body (default \"slider\")"}};
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
    {"speed", "rad/s, or length/s of a slider (default 1)"},
    {"acceleration", "rad/s2 (default 0)"},
    {"start_deg, end_deg", "of the crank (default 0 and a turn more); start, end of a slider"},
    {"steps", "between them, both included (default 360)"}};
constexpr Entry kOutputTable[] = {
    {"want", "a list of these quantities and of points"},
    {"position, velocity, acceleration, transmission", "true by default"},
    {"curvature", "of the points' paths; cusps, inflections, double points (default false)"},
    {"instant_geometry", "bodies whose poles, inflection circles, Ball's points are wanted"},
    {"curve", "length, area, widths... of a four-bar's coupler curve, as metrics (default false)"},
    {"cognates", "Roberts' cognates of a four-bar with a coupler point (default false)"},
    {"reactions, torque", "true by default where there are masses or loads"},
    {"points", "names of those to report (default: all that move)"}};

constexpr KeyedEntry kAnalysisTables[] = {
    {"[[pivot]]", "of a chain: a point of the frame", kPivotTable},
    {"[crank]", "of a chain: what drives", kCrankTable},
    {"[slider]", "of a chain: what drives instead of a crank", kSliderTable},
    {"[[point]]", "a further point of a body", kPointTable},
    {"[[link]]", "mass and inertia of a body", kLinkTable},
    {"[[load]]", "a force or a torque on a body", kLoadTable},
    {"gravity", "[gx, gy] in m/s2 (default [0, 0]); a key, not a table", {}},
    {"[drive]", "how the crank, or the driving slider, moves", kDriveTable},
    {"[output]", "what is wanted; what is not is not computed", kOutputTable}};

}  // namespace

std::span<const KeyedEntry> mechanisms() {
  return kMechanisms;
}

std::span<const KeyedEntry> dyads() {
  return kDyads;
}

std::span<const KeyedEntry> analysis_tables() {
  return kAnalysisTables;
}

}  // namespace cognate::app
