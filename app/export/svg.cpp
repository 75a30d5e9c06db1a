#include "app/export/svg.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

namespace cognate::app {
namespace {

// As shares of the greater side of the plan.
constexpr double kMargin = 0.025, kLine = 0.002;

double greater_side(const Plan& plan) {
  return std::max(plan.high.x - plan.low.x, plan.high.y - plan.low.y);
}

/// Browsers reckon in single precision, and paint what is very small or very large wrongly.
constexpr double kLeastSide = 1e-2, kGreatestSide = 1e6;

/// The power of ten by which lengths are multiplied so that they are painted rightly.
int shift_of(const Plan& plan) {
  constexpr int kDigits = 2;  // the greater side becomes one from 100 to 1000
  const double side = greater_side(plan);
  const bool fits = side == 0 || (side >= kLeastSide && side <= kGreatestSide);
  return fits ? 0 : kDigits - static_cast<int>(std::floor(std::log10(side)));
}

Plan scaled(Plan plan, double by) {
  const auto scale = [&](Vec2d& at) { at = by * at; };
  scale(plan.low);
  scale(plan.high);
  for (auto& outline : plan.outlines) {
    for (auto& corner : outline.corners) scale(corner.at);
  }
  for (auto& circle : plan.circles) {
    scale(circle.centre);
    circle.radius *= by;
  }
  for (auto& label : plan.labels) {
    scale(label.at);
    label.height *= by;
  }
  return plan;
}

const char* paint(PlanColour colour) {
  switch (colour) {
    case PlanColour::accent:
      return "#b8561a";
    case PlanColour::grey:
      return "#888";
    case PlanColour::red:
      return "#c22";
    case PlanColour::green:
      return "#2a8a3c";
    default:
      return "#1668b8";
  }
}

std::string class_of(std::string layer) {
  for (char& c : layer) c = c == '_' ? '-' : 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return layer;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '&':
        out += "&amp;";
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out;
}

/// Colours are readable where the background is dark.
std::string style(const Plan& plan) {
  const double line = kLine * greater_side(plan);
  std::string text = fmt::format(
      "<style>\npath, circle {{ fill: none; stroke-width: {:.3g}; }}\n"
      "text {{ font: 16px sans-serif; }}\n",
      line);
  const std::string dashes = fmt::format(" stroke-dasharray: {:.3g} {:.3g};", 4 * line, 3 * line);
  for (const PlanLayer& layer : plan.layers) {
    const std::string name = class_of(layer.name);
    const char* colour = paint(layer.colour);
    text += fmt::format(".{} {{ stroke: {};{} }}\ntext.{} {{ stroke: none; fill: {}; }}\n", name,
                        colour, layer.dashed ? dashes : std::string(), name, colour);
  }
  return text + "</style>\n";
}

/// The way from one corner to the next: a line, or an arc of a circle.
void append_way(std::string& text, const PlanCorner& from, const PlanCorner& to) {
  const auto out = std::back_inserter(text);
  if (from.bulge == 0) {
    fmt::format_to(out, "L{} {}", to.at.x, to.at.y);
    return;
  }
  const double bulge = std::abs(from.bulge);
  const double radius = norm(to.at - from.at) * (1 + bulge * bulge) / (4 * bulge);
  fmt::format_to(out, "A{0} {0} 0 {1} {2} {3} {4}", radius, bulge > 1 ? 1 : 0,
                 from.bulge > 0 ? 1 : 0, to.at.x, to.at.y);
}

void append_outline(std::string& text, const PlanOutline& outline) {
  const auto& corners = outline.corners;
  if (corners.empty()) return;
  fmt::format_to(std::back_inserter(text), "<path class=\"{}\" d=\"M{} {}", class_of(outline.layer),
                 corners.front().at.x, corners.front().at.y);
  for (std::size_t i = 1; i < corners.size(); ++i) append_way(text, corners[i - 1], corners[i]);
  if (outline.closed && corners.back().bulge != 0) {
    append_way(text, corners.back(), corners.front());
  }
  text += outline.closed ? "Z\"/>\n" : "\"/>\n";
}

void append_circle(std::string& text, const PlanCircle& circle) {
  fmt::format_to(std::back_inserter(text), "<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n",
                 class_of(circle.layer), circle.centre.x, circle.centre.y, circle.radius);
}

/// Texts stand upright in a picture whose y axis is turned. Fonts are scaled, as viewers draw very
/// small and very large ones badly.
void append_label(std::string& text, const PlanLabel& label) {
  constexpr double kFont = 16;
  const double scale = label.height / kFont;
  fmt::format_to(std::back_inserter(text),
                 "<text class=\"{}\" transform=\"translate({} {}) scale({} {})\">{}</text>\n",
                 class_of(label.layer), label.at.x, label.at.y, scale, -scale, escaped(label.text));
}

/// The attributes `width` and `height` of a picture that is so large in `unit`.
std::string true_size(double width, double height, problems::LengthUnit unit) {
  const double millimetres = 1000 * metres(unit);
  return fmt::format(" width=\"{:.10g}mm\" height=\"{:.10g}mm\"", millimetres * width,
                     millimetres * height);
}

/// The document of a plan whose lengths are painted as they are, `scale` times those of the
/// problem; `description` says so.
std::string document(const Plan& plan, double scale, const std::string& description) {
  const Vec2d size = plan.high - plan.low;
  const double margin = kMargin * greater_side(plan);
  const double width = size.x + 2 * margin, height = size.y + 2 * margin;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\"{} viewBox=\"{} {} {} {}\">\n",
      plan.length_unit ? true_size(width / scale, height / scale, *plan.length_unit) : "",
      plan.low.x - margin, -plan.high.y - margin, width, height);
  text += "<title>" + escaped(plan.title) + "</title>\n";
  text += description;
  text += style(plan);
  text += "<g transform=\"scale(1 -1)\">\n";
  for (const auto& outline : plan.outlines) append_outline(text, outline);
  for (const auto& circle : plan.circles) append_circle(text, circle);
  for (const auto& label : plan.labels) append_label(text, label);
  text += "</g>\n</svg>\n";
  return text;
}

}  // namespace

std::string svg_text(const Plan& plan) {
  const int shift = shift_of(plan);
  if (shift == 0) return document(plan, 1, "");
  const double scale = std::pow(10.0, shift);
  return document(
      scaled(plan, scale), scale,
      fmt::format("<desc>Lengths are those of the problem times 1e{}.</desc>\n", shift));
}

}  // namespace cognate::app
