#include "app/export/chain_sketch.hpp"

#include <fmt/core.h>

#include <string_view>

namespace cognate::app {
namespace {

/// In quotes, as Graphviz reads it; a line break is a line break of the label.
std::string graph_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n') {
      out += "\\n";
    } else {
      out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out + '"';
}

/// The link's name, and how far its joints are from one another.
std::string label_of(const LinkShape& link) {
  std::string text = link.name;
  for (std::size_t i = 0; i < link.places.size(); ++i) {
    for (std::size_t k = i + 1; k < link.places.size(); ++k) {
      const LinkPlace &a = link.places[i], &b = link.places[k];
      text += fmt::format("\n{}-{} {:.6g}", a.name, b.name, norm(b.at - a.at));
    }
  }
  return text;
}

}  // namespace

std::string chain_sketch(const std::string& title, const LinkShapes& shown) {
  std::string text = "graph " + graph_text(title) +
                     " {\n  node [shape=box, style=rounded];\n  edge [fontsize=11];\n";
  for (std::size_t i = 0; i < shown.links.size(); ++i) {
    text += fmt::format("  link{} [label={}{}];\n", i, graph_text(label_of(shown.links[i])),
                        i == 0 ? ", peripheries=2, style=filled, fillcolor=lightgrey" : "");
  }
  for (const JointShape& joint : shown.joints) {
    const bool slides = joint.type == JointType::prismatic;
    text += fmt::format("  link{} -- link{} [label={}{}];\n", joint.first, joint.second,
                        graph_text(slides ? joint.name + "\nslides" : joint.name),
                        slides ? ", style=dashed" : "");
  }
  return text + "}\n";
}

}  // namespace cognate::app
