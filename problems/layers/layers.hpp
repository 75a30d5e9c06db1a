/// @file `[layers]`: in how many layers the links of a mechanism pass each other.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cognate::problems {

/// The width of one link that has its own.
struct LinkWidth {
  std::string link;
  double width = 0;
};

/// `[layers]`: sizes of links and pins.
struct LayerSizes {
  double link_width = 0;
  double pin_diameter = 0;
  double clearance = 0;
  std::optional<double> thickness{};  ///< of a link: how high a layer is
  std::vector<LinkWidth> widths{};    ///< in the order of the bodies
};

/// `[layers]` of a problem whose designs are to be layered, and `constraints.layers_max`.
struct DesignLayers {
  LayerSizes sizes;
  std::optional<int> max{};  ///< layers above the frame that a design may need
};

/// Why two parts cannot share a layer: they are joined or slide on each other; they collide; or it
/// could not be proven that they do not.
enum class LayerConflictKind { joint, slide, collision, unresolved };

/// Two parts that cannot share a layer: links, pins, or a pin and a link.
struct LayerConflict {
  std::string first, second;
  bool first_is_pin = false, second_is_pin = false;
  LayerConflictKind kind = LayerConflictKind::collision;
  std::optional<double> drive{};  ///< where first: radians or length; none of joints and slides
};

/// The layer of each link; what stands in no layer is not named.
struct LayerResult {
  struct Link {
    std::string name;
    double width = 0;
    int layer = 0;  ///< from 1 above the base; 0 where there is no assignment
  };
  struct Pin {
    std::string name;
    std::vector<std::string> joins;  ///< links, and "frame"
    std::vector<int> crosses;        ///< layers in which it holds no link
  };
  std::optional<int> count;  ///< empty where no number of layers suffices
  std::vector<Link> links;
  std::vector<Pin> pins;
  std::vector<LayerConflict> conflicts;
  std::vector<std::string> blocked;  ///< without an assignment: links that have none by themselves
  std::size_t cells = 0;             ///< of the drive that were examined
  std::size_t tried = 0;             ///< layers tried on top of sets of links
};

}  // namespace cognate::problems
