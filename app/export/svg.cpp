#include "app/export/svg.hpp"

#include <fmt/core.h>

#include <iterator>
#include <string_view>

namespace cognate::app {
namespace {

constexpr double kMargin = 1.05;  // of the reach: what the picture shows

// Lines are thin at any size of the picture, and readable where the background is dark.
constexpr std::string_view kStyle = R"(<style>
path, circle { fill: none; stroke: #444; }
.profile { stroke: #1668b8; }
.pitch, .cutter { stroke: #b8561a; }
.base-circle { stroke-dasharray: 4 3; stroke: #888; }
path, circle { stroke-width: 1px; vector-effect: non-scaling-stroke; }
</style>
)";

const char* class_of(ExportedCurve kind) {
  switch (kind) {
    case ExportedCurve::pitch:
      return "pitch";
    case ExportedCurve::cutter:
      return "cutter";
    default:
      return "profile";
  }
}

void append_curve(std::string& text, const DrawnCurve& curve, const char* kind) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "<path class=\"{}\" d=\"", kind);
  char command = 'M';
  for (const auto& point : curve.points) {
    fmt::format_to(out, "{}{} {}", command, point.at.x, point.at.y);
    command = 'L';
  }
  text += "Z\"/>\n";
  if (curve.base_radius > 0) {
    fmt::format_to(out, "<circle class=\"base-circle\" r=\"{}\"/>\n", curve.base_radius);
  }
}

}  // namespace

std::string svg_text(const CamDrawing& drawing) {
  const double reach = reach_of(drawing);
  const double half = kMargin * reach;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {} {}\">\n"
      "<title>Cam: {}</title>\n",
      -half, -half, 2 * half, 2 * half, class_of(drawing.kind));
  text += kStyle;
  text += "<g transform=\"scale(1 -1)\">\n";
  for (const auto& curve : drawing.curves) append_curve(text, curve, class_of(drawing.kind));
  const double arm = kCentreMark * reach;
  text += fmt::format("<path class=\"centre\" d=\"M{0} 0L{1} 0M0 {0}L0 {1}\"/>\n", -arm, arm);
  text += "</g>\n</svg>\n";
  return text;
}

}  // namespace cognate::app
