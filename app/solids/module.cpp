/// @file What the program finds in this module.
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <cmath>
#include <exception>
#include <mutex>

#include "app/solids/shape.hpp"
#include "app/solids/texts.hpp"

namespace cognate::app {
namespace {

double volume_of(const TopoDS_Shape& shape) {
  // By Gauss and Kronrod: the plain rule is a hundredth off on faces with splines about them.
  GProp_GProps properties;
  constexpr double kAccuracy = 1e-7;
  BRepGProp::VolumePropertiesGK(shape, properties, kAccuracy, true, true);
  return properties.Mass();
}

ShapedSolids shaped_solids(const SolidAssembly& assembly, SolidFormat format,
                           const std::string*& current) {
  ShapedSolids made;
  std::vector<TopoDS_Shape> shapes;
  const double tolerance = assembly.chord_tolerance * assembly.millimetres;
  const auto facets = format == SolidFormat::stl ? std::optional(tolerance) : std::nullopt;
  for (const Solid& solid : assembly.solids) {
    current = &solid.name;
    shapes.push_back(shape_of(solid, assembly.millimetres, facets));
    made.volumes.push_back(volume_of(shapes.back()) / std::pow(assembly.millimetres, 3));
    if (format == SolidFormat::step) continue;
    made.texts.push_back(stl_text(solid.name, shapes.back(), tolerance));
  }
  current = &assembly.title;
  if (format == SolidFormat::step) made.texts.push_back(step_text(assembly, shapes));
  return made;
}

}  // namespace
}  // namespace cognate::app

extern "C" [[gnu::visibility("default")]] void cognate_shape_solids(
    const cognate::app::SolidAssembly& assembly, cognate::app::SolidFormat format,
    tl::expected<cognate::app::ShapedSolids, std::string>& shaped) {
  // OpenCASCADE has one session and one set of parameters.
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  Message::DefaultMessenger()->ChangePrinters().Clear();
  const std::string* current = &assembly.title;
  try {
    shaped = cognate::app::shaped_solids(assembly, format, current);
  } catch (const Standard_Failure& failure) {
    shaped = tl::unexpected("no solid can be made of " + *current + ": OpenCASCADE says " +
                            failure.DynamicType()->Name() + ' ' + failure.GetMessageString());
  } catch (const std::exception& error) {
    shaped = tl::unexpected("no solid can be made of " + *current + ": " + error.what());
  }
}
