#include <fmt/core.h>

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <gp_Vec.hxx>
#include <iterator>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "app/solids/texts.hpp"

namespace cognate::app {
namespace {

using Facet = std::array<gp_Pnt, 3>;

std::vector<Facet> facets_of(const TopoDS_Shape& shape) {
  std::vector<Facet> facets;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face& face = TopoDS::Face(faces.Current());
    TopLoc_Location placed;
    const auto mesh = BRep_Tool::Triangulation(face, placed);
    if (mesh.IsNull()) continue;
    for (int i = 1; i <= mesh->NbTriangles(); ++i) {
      std::array<int, 3> corner{};
      mesh->Triangle(i).Get(corner[0], corner[1], corner[2]);
      if (face.Orientation() == TopAbs_REVERSED) std::swap(corner[1], corner[2]);
      Facet& facet = facets.emplace_back();
      for (std::size_t k = 0; k < facet.size(); ++k) {
        facet.at(k) = mesh->Node(corner.at(k)).Transformed(placed.Transformation());
      }
    }
  }
  return facets;
}

double lowest(const std::vector<Facet>& facets) {
  double low = kInfinity;
  for (const Facet& facet : facets) {
    for (const gp_Pnt& corner : facet) low = std::min(low, corner.Z());
  }
  return low;
}

}  // namespace

std::string stl_text(const std::string& name, const TopoDS_Shape& shape, double tolerance) {
  constexpr double kLeastAngle = 0.5;  // radians between neighbouring facets
  const BRepMesh_IncrementalMesh mesh(shape, tolerance, false, kLeastAngle);
  const auto facets = facets_of(shape);
  const double low = lowest(facets);
  std::string text = "solid " + name + '\n';
  const auto out = std::back_inserter(text);
  for (const Facet& facet : facets) {
    gp_Vec normal = gp_Vec(facet[0], facet[1]).Crossed(gp_Vec(facet[0], facet[2]));
    if (normal.Magnitude() > 0) normal.Normalize();
    fmt::format_to(out, "facet normal {:.6g} {:.6g} {:.6g}\nouter loop\n", normal.X(), normal.Y(),
                   normal.Z());
    for (const gp_Pnt& corner : facet) {
      fmt::format_to(out, "vertex {:.9g} {:.9g} {:.9g}\n", corner.X(), corner.Y(),
                     corner.Z() - low);
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid " + name + '\n';
}

}  // namespace cognate::app
