#include "app/export/dxf.hpp"

#include <dxflib/dl_dxf.h>

#include <array>
#include <charconv>
#include <string_view>

namespace cognate::app {
namespace {

/// Colours by AutoCAD's index: one to draw with on black and on white, and muted ones.
constexpr int kForeground = 7, kRed = 1, kGrey = 8;

/// The library's own writer goes to a file, with sixteen places behind the decimal point.
class TextWriter : public DL_WriterA {
 public:
  TextWriter() : DL_WriterA("") {}

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

const char* layer_of(ExportedCurve kind) {
  switch (kind) {
    case ExportedCurve::pitch:
      return "PITCH";
    case ExportedCurve::cutter:
      return "CUTTER";
    default:
      return "PROFILE";
  }
}

/// Colour and layer of an entity.
DL_Attributes on_layer(const char* layer) {
  constexpr int kByLayer = 256, kWidthByLayer = -1;
  return {layer, kByLayer, kWidthByLayer, "BYLAYER", 1.0};
}

void write_header(DL_Dxf& dxf, TextWriter& out, double reach) {
  dxf.writeHeader(out);
  out.dxfString(9, "$INSUNITS");
  out.dxfInt(70, 0);
  out.dxfString(9, "$EXTMIN");
  out.coord(10, -reach, -reach);
  out.dxfString(9, "$EXTMAX");
  out.coord(10, reach, reach);
  out.sectionEnd();
}

void write_linetypes(DL_Dxf& dxf, TextWriter& out) {
  constexpr std::array kLines = {"BYBLOCK", "BYLAYER", "CONTINUOUS"};
  out.tableLinetypes(static_cast<int>(kLines.size()));
  for (const char* line : kLines) dxf.writeLinetype(out, DL_LinetypeData(line, "", 0, 0, 0.0));
  out.tableEnd();
}

void write_layers(DL_Dxf& dxf, TextWriter& out, ExportedCurve kind) {
  struct Layer {
    const char* name;
    int colour;
  };
  const std::array<Layer, 4> layers = {{{"0", kForeground},
                                        {layer_of(kind), kForeground},
                                        {"BASE_CIRCLE", kGrey},
                                        {"CENTRE", kRed}}};
  out.tableLayers(static_cast<int>(layers.size()));
  for (const auto& layer : layers) {
    dxf.writeLayer(out, DL_LayerData(layer.name, 0),
                   DL_Attributes("", layer.colour, -1, "CONTINUOUS", 1.0));
  }
  out.tableEnd();
}

/// The tables that release 2000 wants, most of them with nothing of ours.
void write_tables(DL_Dxf& dxf, TextWriter& out, ExportedCurve kind) {
  out.sectionTables();
  dxf.writeVPort(out);
  write_linetypes(dxf, out);
  write_layers(dxf, out, kind);
  out.tableStyle(1);
  dxf.writeStyle(out, DL_StyleData("Standard", 0, 0.0, 1.0, 0.0, 0, 2.5, "txt", ""));
  out.tableEnd();
  dxf.writeView(out);
  dxf.writeUcs(out);
  out.tableAppid(1);
  dxf.writeAppid(out, "ACAD");
  out.tableEnd();
  dxf.writeDimStyle(out, 1, 1, 1, 1, 1);
  dxf.writeBlockRecord(out);
  out.tableEnd();
  out.sectionEnd();
}

void write_blocks(DL_Dxf& dxf, TextWriter& out) {
  out.sectionBlocks();
  for (const char* name : {"*Model_Space", "*Paper_Space", "*Paper_Space0"}) {
    dxf.writeBlock(out, DL_BlockData(name, 0, 0.0, 0.0, 0.0));
    dxf.writeEndBlock(out, name);
  }
  out.sectionEnd();
}

void write_curve(DL_Dxf& dxf, TextWriter& out, const DrawnCurve& curve, const char* layer) {
  constexpr int kClosed = 1;
  const int count = static_cast<int>(curve.points.size());
  dxf.writePolyline(out, DL_PolylineData(count, 0, 0, kClosed), on_layer(layer));
  for (const auto& point : curve.points) {
    dxf.writeVertex(out, DL_VertexData(point.at.x, point.at.y));
  }
  dxf.writePolylineEnd(out);
}

void write_entities(DL_Dxf& dxf, TextWriter& out, const CamDrawing& drawing) {
  out.sectionEntities();
  for (const auto& curve : drawing.curves) {
    write_curve(dxf, out, curve, layer_of(drawing.kind));
    if (curve.base_radius <= 0) continue;
    dxf.writeCircle(out, DL_CircleData(0, 0, 0, curve.base_radius), on_layer("BASE_CIRCLE"));
  }
  const double arm = kCentreMark * reach_of(drawing);
  dxf.writeLine(out, DL_LineData(-arm, 0, 0, arm, 0, 0), on_layer("CENTRE"));
  dxf.writeLine(out, DL_LineData(0, -arm, 0, 0, arm, 0), on_layer("CENTRE"));
  out.sectionEnd();
}

}  // namespace

std::string dxf_text(const CamDrawing& drawing) {
  DL_Dxf dxf;
  TextWriter out;
  write_header(dxf, out, reach_of(drawing));
  write_tables(dxf, out, drawing.kind);
  write_blocks(dxf, out);
  write_entities(dxf, out, drawing);
  dxf.writeObjects(out);
  dxf.writeObjectsEnd(out);
  out.dxfEOF();
  return out.text();
}

}  // namespace cognate::app
