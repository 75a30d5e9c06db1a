#include "app/export/dxf.hpp"

#include <dxflib/dl_dxf.h>
#include <fmt/core.h>

#include <array>
#include <charconv>
#include <memory>
#include <string_view>
#include <vector>

namespace cognate::app {
namespace {

/// By AutoCAD's index: the foreground is black on white and white on black.
int colour_index(PlanColour colour) {
  switch (colour) {
    case PlanColour::accent:
      return 30;
    case PlanColour::grey:
      return 8;
    case PlanColour::red:
      return 1;
    case PlanColour::green:
      return 3;
    default:
      return 7;
  }
}

/// By the table of $INSUNITS; 0 says that there is no unit.
int unit_index(std::optional<problems::LengthUnit> unit) {
  if (!unit) return 0;
  switch (*unit) {
    case problems::LengthUnit::mm:
      return 4;
    case problems::LengthUnit::cm:
      return 5;
    case problems::LengthUnit::m:
      return 6;
    case problems::LengthUnit::inch:
      return 1;
  }
  return 0;
}

/// The library's own writer goes to a file, with sixteen places behind the decimal point.
class TextWriter : public DL_WriterA {
 public:
  explicit TextWriter(DL_Codes::version version) : DL_WriterA("", version) {}

  void dxfReal(int code, double value) const override {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    std::string_view text(digits.data(), static_cast<std::size_t>(end - digits.data()));
    append(code, text);
    if (text.find_first_of(".en") == std::string_view::npos) {
      text_.insert(text_.size() - 1, ".0");
    }
  }
  void dxfInt(int code, int value) const override { append(code, std::to_string(value)); }
  void dxfHex(int code, int value) const override {
    std::array<char, 16> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, 16).ptr;
    append(code, {digits.data(), static_cast<std::size_t>(end - digits.data())});
  }
  void dxfString(int code, const char* value) const override { append(code, value); }
  void dxfString(int code, const std::string& value) const override { append(code, value); }

  const std::string& text() const { return text_; }

 private:
  void append(int code, std::string_view value) const {
    text_ += std::to_string(code);
    text_ += '\n';
    text_ += value;
    text_ += '\n';
  }

  mutable std::string text_;  // the interface to override is const
};

/// Colour and layer of an entity.
DL_Attributes on_layer(const std::string& layer) {
  constexpr int kByLayer = 256, kWidthByLayer = -1;
  return {layer, kByLayer, kWidthByLayer, "BYLAYER", 1.0};
}

/// ASCII, with every other character of UTF-8 `text` as CAD programs write it: \U+00E9.
std::string ascii(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t bytes = lead < 0x80 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
    unsigned code = bytes == 1 ? lead : lead & (0x7fU >> bytes);
    for (std::size_t k = 1; k < bytes && i + k < text.size(); ++k) {
      code = code << 6U | (static_cast<unsigned char>(text[i + k]) & 0x3fU);
    }
    i += bytes;
    if (code < 0x80) {
      out += code < 0x20 ? ' ' : static_cast<char>(code);
    } else {
      out += code > 0xffff ? "?" : fmt::format("\\U+{:04X}", code);
    }
  }
  return out;
}

/// Writes one plan. The library asks its own version at every entity.
class DxfMaker {
 public:
  DxfMaker(const Plan& plan, DxfVersion version)
      : plan_(plan),
        old_(version == DxfVersion::r12),
        out_(old_ ? DL_Codes::AC1009 : DL_Codes::AC1015) {
    // Only opening a file sets the library's version; what is written goes to `out_`.
    const std::unique_ptr<DL_WriterA> unused(
        dxf_.out("/dev/null", old_ ? DL_Codes::AC1009 : DL_Codes::AC1015));
  }

  std::string text() {
    write_header();
    write_tables();
    if (!old_) write_blocks();
    write_entities();
    if (!old_) {
      dxf_.writeObjects(out_);
      dxf_.writeObjectsEnd(out_);
    }
    out_.dxfEOF();
    return out_.text();
  }

 private:
  void write_header() {
    dxf_.writeHeader(out_);
    if (!old_) {
      out_.dxfString(9, "$INSUNITS");
      out_.dxfInt(70, unit_index(plan_.length_unit));
    }
    if (!old_ && plan_.length_unit) {
      out_.dxfString(9, "$MEASUREMENT");
      out_.dxfInt(70, plan_.length_unit == problems::LengthUnit::inch ? 0 : 1);
    }
    out_.dxfString(9, "$EXTMIN");
    out_.coord(10, plan_.low.x, plan_.low.y);
    out_.dxfString(9, "$EXTMAX");
    out_.coord(10, plan_.high.x, plan_.high.y);
    out_.sectionEnd();
  }

  void write_linetypes() {
    std::vector<const char*> lines = {"CONTINUOUS"};
    if (!old_) lines.insert(lines.begin(), {"BYBLOCK", "BYLAYER"});
    out_.tableLinetypes(static_cast<int>(lines.size()));
    for (const char* line : lines) dxf_.writeLinetype(out_, DL_LinetypeData(line, "", 0, 0, 0.0));
    out_.tableEnd();
  }

  void write_layer(const std::string& name, PlanColour colour) {
    dxf_.writeLayer(out_, DL_LayerData(name, 0),
                    DL_Attributes("", colour_index(colour), -1, "CONTINUOUS", 1.0));
  }

  /// The tables that release 2000 wants, most of them with nothing of ours.
  void write_tables() {
    out_.sectionTables();
    dxf_.writeVPort(out_);
    write_linetypes();
    out_.tableLayers(static_cast<int>(plan_.layers.size()) + 1);
    write_layer("0", PlanColour::foreground);
    for (const PlanLayer& layer : plan_.layers) write_layer(layer.name, layer.colour);
    out_.tableEnd();
    out_.tableStyle(1);
    dxf_.writeStyle(out_, DL_StyleData("Standard", 0, 0.0, 1.0, 0.0, 0, 2.5, "txt", ""));
    out_.tableEnd();
    if (!old_) write_tables_of_2000();
    out_.sectionEnd();
  }

  void write_tables_of_2000() {
    dxf_.writeView(out_);
    dxf_.writeUcs(out_);
    out_.tableAppid(1);
    dxf_.writeAppid(out_, "ACAD");
    out_.tableEnd();
    dxf_.writeDimStyle(out_, 1, 1, 1, 1, 1);
    dxf_.writeBlockRecord(out_);
    out_.tableEnd();
  }

  void write_blocks() {
    out_.sectionBlocks();
    for (const char* name : {"*Model_Space", "*Paper_Space", "*Paper_Space0"}) {
      dxf_.writeBlock(out_, DL_BlockData(name, 0, 0.0, 0.0, 0.0));
      dxf_.writeEndBlock(out_, name);
    }
    out_.sectionEnd();
  }

  void write_outline(const PlanOutline& outline) {
    const auto& corners = outline.corners;
    const auto layer = on_layer(outline.layer);
    if (corners.size() == 2 && !outline.closed && corners.front().bulge == 0) {
      const Vec2d &from = corners.front().at, &to = corners.back().at;
      dxf_.writeLine(out_, DL_LineData(from.x, from.y, 0, to.x, to.y, 0), layer);
      return;
    }
    const int count = static_cast<int>(corners.size());
    dxf_.writePolyline(out_, DL_PolylineData(count, 0, 0, outline.closed ? 1 : 0), layer);
    for (const PlanCorner& corner : corners) {
      dxf_.writeVertex(out_, DL_VertexData(corner.at.x, corner.at.y, 0, corner.bulge));
    }
    dxf_.writePolylineEnd(out_);
  }

  void write_label(const PlanLabel& label) {
    const auto& [x, y] = label.at;
    dxf_.writeText(
        out_,
        DL_TextData(x, y, 0, x, y, 0, label.height, 1, 0, 0, 0, ascii(label.text), "Standard", 0),
        on_layer(label.layer));
  }

  void write_entities() {
    out_.sectionEntities();
    for (const auto& outline : plan_.outlines) write_outline(outline);
    for (const auto& [layer, centre, radius] : plan_.circles) {
      dxf_.writeCircle(out_, DL_CircleData(centre.x, centre.y, 0, radius), on_layer(layer));
    }
    for (const auto& label : plan_.labels) write_label(label);
    out_.sectionEnd();
  }

  const Plan& plan_;
  bool old_;
  DL_Dxf dxf_;
  TextWriter out_;
};

}  // namespace

std::string dxf_text(const Plan& plan, DxfVersion version) {
  return DxfMaker(plan, version).text();
}

}  // namespace cognate::app
