/// @file The keys of `[raster]`, each declared once: the reader, what is written of it and
/// `cognate list` run over the declarations.
#pragma once

#include <array>
#include <string_view>

namespace cognate::problems {

struct RasterKey {
  std::string_view key;
  std::string_view meaning;
  bool may_be_negative = false;  ///< its values are coordinates, not lengths
};

inline constexpr std::array kRasterKeys{
    RasterKey{
        "length",
        "all dimensions that have no key of their own: STEP (multiples of it), [VALUE, ...] or "
        "\"free\"",
        true},
    RasterKey{"pivots", "both coordinates of the fixed pivots; the frame then follows from them",
              true},
    RasterKey{"coupler_point", "both coordinates of points of the coupler", true},
    RasterKey{"moving_pivots", "both coordinates of the moving pivots in the body's axes", true},
    RasterKey{"crank", "the crank"},
    RasterKey{"coupler", "the coupler"},
    RasterKey{"rocker", "the rocker"},
    RasterKey{"frame", "the frame, where the pivots are free or not searched"},
    RasterKey{"offset", "the offset of a slider-crank, of a cam's follower", true},
    RasterKey{"bar", "of shapers: the bar, from its pivot to the rod"},
    RasterKey{"rod", "of shapers: from the bar to the ram"},
    RasterKey{"ram_height", "of shapers: of the ram's line above the bar's pivot"},
    RasterKey{"base_radius",
              "of cams: that of the prime circle, of flat faces and knife edges of the "
              "base circle"},
    RasterKey{"roller_radius", "of cams: the roller"},
    RasterKey{"centre_distance", "of cams: the follower's pivot from the cam's centre"},
    RasterKey{"arm", "of cams: from the pivot to the roller's centre"},
    RasterKey{"face_offset", "of cams: by how much the face lies nearer than its pivot", true}};

inline constexpr std::string_view kRasterBoxesKey = "boxes";
inline constexpr std::string_view kRasterBoxesMeaning =
    "how many boxes branch and bound examines at most (default 20000, of quick returns 1000000)";
inline constexpr std::string_view kRasterFree = "free";

}  // namespace cognate::problems
