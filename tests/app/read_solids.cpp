/// @file What is in a STEP file, for tests: read_solids FILE writes JSON, in millimetres.
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TDF_ChildIterator.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <cstdio>
#include <gp_Cylinder.hxx>
#include <iostream>
#include <nlohmann/json.hpp>

namespace {

using nlohmann::json;

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return "";
  const TCollection_ExtendedString& text = name->Get();
  std::string utf8(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
  Standard_PCharacter out = utf8.data();
  text.ToUTF8CString(out);
  return utf8.c_str();
}

json cylinders_of(const TopoDS_Shape& shape) {
  json list = json::array();
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    const BRepAdaptor_Surface surface(TopoDS::Face(faces.Current()));
    if (surface.GetType() != GeomAbs_Cylinder) continue;
    const gp_Cylinder cylinder = surface.Cylinder();
    const gp_Pnt at = cylinder.Axis().Location();
    list.push_back({{"radius", cylinder.Radius()}, {"at", {at.X(), at.Y()}}});
  }
  return list;
}

/// Each once.
json vertices_of(const TopoDS_Shape& shape) {
  json list = json::array();
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
  for (int i = 1; i <= vertices.Extent(); ++i) {
    const gp_Pnt at = BRep_Tool::Pnt(TopoDS::Vertex(vertices(i)));
    list.push_back({at.X(), at.Y(), at.Z()});
  }
  return list;
}

json described(const std::string& name, const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumePropertiesGK(shape, properties, 1e-7, true, true);
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  double low[3], high[3];
  box.Get(low[0], low[1], low[2], high[0], high[1], high[2]);
  return {{"name", name},
          {"volume", properties.Mass()},
          {"valid", static_cast<bool>(BRepCheck_Analyzer(shape).IsValid())},
          {"low", low},
          {"high", high},
          {"cylinders", cylinders_of(shape)},
          {"vertices", vertices_of(shape)}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  Message::DefaultMessenger()->ChangePrinters().Clear();
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
  STEPCAFControl_Reader reader;
  if (reader.ReadFile(argv[1]) != IFSelect_RetDone || !reader.Transfer(document)) return 1;
  const auto tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  TDF_LabelSequence assemblies;
  tool->GetFreeShapes(assemblies);
  json out = json::array();
  for (const TDF_Label& assembly : assemblies) {
    TDF_LabelSequence parts;
    XCAFDoc_ShapeTool::GetComponents(assembly, parts);
    json solids = json::array();
    for (const TDF_Label& part : parts) {
      TDF_Label product;
      XCAFDoc_ShapeTool::GetReferredShape(part, product);
      solids.push_back(described(name_of(product), XCAFDoc_ShapeTool::GetShape(part)));
    }
    out.push_back({{"name", name_of(assembly)}, {"solids", solids}});
  }
  std::cout << out.dump() << '\n';
  return 0;
}
