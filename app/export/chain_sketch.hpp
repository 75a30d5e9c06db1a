/// @file The kinematic chain of a linkage as a graph.
#pragma once

#include <string>

#include "app/drawing/link_shapes.hpp"

namespace cognate::app {

/// The chain in the language of Graphviz: a node for each link with the distances of its joints,
/// the frame marked, and an edge for each joint, dashed where it slides.
std::string chain_sketch(const std::string& title, const LinkShapes& shown);

}  // namespace cognate::app
