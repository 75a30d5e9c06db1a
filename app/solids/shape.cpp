#include "app/solids/shape.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Vec.hxx>
#include <stdexcept>

#include "app/solids/twisted.hpp"
#include "app/solids/wire.hpp"

namespace cognate::app {
namespace {

TopoDS_Shape prism_of(const SolidPrism& prism, double millimetres, std::optional<double> facets) {
  if (prism.twist != 0) return twisted_prism(prism, millimetres, facets);
  const double low = millimetres * prism.low, high = millimetres * prism.high;
  BRepBuilderAPI_MakeFace face(wire_of(prism.loop, low, millimetres), true);
  if (prism.hollow) face.Add(TopoDS::Wire(wire_of(*prism.hollow, low, millimetres).Reversed()));
  return BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0, 0, high - low)).Shape();
}

/// Beyond the material above and below, so that no face of the hole lies in one of the material's.
SolidPrism beyond(SolidPrism hole) {
  const double margin = 0.5 * (hole.high - hole.low);
  hole.low -= margin;
  hole.high += margin;
  return hole;
}

template <class Operation>
TopoDS_Shape combined(const TopoDS_Shape& one, const TopTools_ListOfShape& others) {
  if (others.IsEmpty()) return one;
  TopTools_ListOfShape arguments;
  arguments.Append(one);
  Operation operation;
  operation.SetArguments(arguments);
  operation.SetTools(others);
  operation.Build();
  if (operation.HasErrors()) throw std::runtime_error("its outlines do not go together");
  return operation.Shape();
}

/// The single solid that `shape` holds.
TopoDS_Shape only_solid(const TopoDS_Shape& shape) {
  TopExp_Explorer solids(shape, TopAbs_SOLID);
  if (!solids.More()) throw std::runtime_error("its holes leave nothing of it");
  const TopoDS_Shape solid = solids.Current();
  solids.Next();
  if (solids.More()) throw std::runtime_error("its holes cut it into pieces");
  return solid;
}

}  // namespace

TopoDS_Shape shape_of(const Solid& solid, double millimetres, std::optional<double> facets) {
  const auto made = [&](const SolidPrism& prism) { return prism_of(prism, millimetres, facets); };
  TopTools_ListOfShape more, holes;
  for (std::size_t i = 1; i < solid.material.size(); ++i) more.Append(made(solid.material[i]));
  for (const SolidPrism& hole : solid.holes) holes.Append(made(beyond(hole)));
  TopoDS_Shape shape = made(solid.material.front());
  shape = combined<BRepAlgoAPI_Fuse>(shape, more);
  shape = combined<BRepAlgoAPI_Cut>(shape, holes);
  ShapeUpgrade_UnifySameDomain unify(shape);
  unify.Build();
  shape = only_solid(unify.Shape());
  if (!BRepCheck_Analyzer(shape).IsValid()) {
    throw std::runtime_error("its outline touches or crosses itself");
  }
  return shape;
}

}  // namespace cognate::app
