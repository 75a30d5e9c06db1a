#include <fmt/core.h>

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gp_Trsf.hxx>
#include <iterator>
#include <stdexcept>

#include "app/solids/texts.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

/// A file name in a folder that goes with its owner: the writer knows files alone.
class ScratchFile {
 public:
  ScratchFile() {
    std::string name = (fs::temp_directory_path() / "cognate-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw std::runtime_error("no folder can be made in " + fs::temp_directory_path().string());
    }
    folder_ = name;
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  std::string path() const { return folder_ / "solids.step"; }

  std::string text() const {
    std::ifstream stream(path(), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

 private:
  fs::path folder_;
};

void set_name(const TDF_Label& label, const std::string& name) {
  TDataStd_Name::Set(label, TCollection_ExtendedString(name.c_str(), true));
}

/// UTF-8 within strings, which OpenCASCADE writes as it is, as ISO 10303-21 has it: \X2\, four
/// hexadecimal digits for each unit of UTF-16, \X0\.
std::string in_basic_alphabet(const std::string& text) {
  const auto is_plain = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  std::string encoded;
  for (auto at = text.begin(); at != text.end();) {
    const auto beyond = std::find_if_not(at, text.end(), is_plain);
    encoded.append(at, beyond);
    at = std::find_if(beyond, text.end(), is_plain);
    if (at == beyond) continue;
    const TCollection_ExtendedString units(std::string(beyond, at).c_str(), true);
    encoded += "\\X2\\";
    for (int i = 1; i <= units.Length(); ++i) {
      encoded += fmt::format("{:04X}", static_cast<unsigned>(units.Value(i)));
    }
    encoded += "\\X0\\";
  }
  return encoded;
}

TopLoc_Location location_of(const Solid& solid, double millimetres) {
  gp_Trsf turn, move;
  turn.SetRotation(gp::OZ(), std::atan2(solid.direction.y, solid.direction.x));
  move.SetTranslation({millimetres * solid.at.x, millimetres * solid.at.y, 0});
  return {move * turn};
}

Handle(TDocStd_Document)
    document_of(const SolidAssembly& assembly, const std::vector<TopoDS_Shape>& shapes) {
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
  const auto tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const TDF_Label whole = tool->NewShape();
  set_name(whole, assembly.title);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Solid& solid = assembly.solids[i];
    const TDF_Label part = tool->AddShape(shapes[i], false);
    set_name(part, solid.name);
    const TDF_Label placed =
        tool->AddComponent(whole, part, location_of(solid, assembly.millimetres));
    set_name(placed, solid.name);
  }
  tool->UpdateAssemblies();
  return document;
}

/// The same for the same solids: no time, no name of a machine.
void write_header(const SolidAssembly& assembly, STEPCAFControl_Writer& writer) {
  const auto text = [](const char* of) { return new TCollection_HAsciiString(of); };
  APIHeaderSection_MakeHeader header(writer.ChangeWriter().Model());
  header.SetName(text(assembly.title.c_str()));
  header.SetTimeStamp(text("1970-01-01T00:00:00"));
  header.SetOriginatingSystem(text("Cognate"));
}

}  // namespace

std::string step_text(const SolidAssembly& assembly, const std::vector<TopoDS_Shape>& shapes) {
  const auto document = document_of(assembly, shapes);
  STEPCAFControl_Writer writer;
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("write.step.unit", "MM");
  Interface_Static::SetIVal("write.surfacecurve.mode", 0);
  const ScratchFile file;
  const bool done = writer.Transfer(document, STEPControl_AsIs);
  if (done) write_header(assembly, writer);
  const bool written = done && writer.Write(file.path().c_str()) == IFSelect_RetDone;
  XCAFApp_Application::GetApplication()->Close(document);
  if (!written) throw std::runtime_error("OpenCASCADE writes no STEP of it");
  return in_basic_alphabet(file.text());
}

}  // namespace cognate::app
