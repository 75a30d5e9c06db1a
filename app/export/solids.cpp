#include "app/export/solids.hpp"

#include "app/documents/module.hpp"

namespace cognate::app {

SolidLoop circle_loop(const Vec2d& centre, double radius) {
  return {{}, centre, radius};
}

tl::expected<ShapedSolids, std::string> shape_solids(const SolidAssembly& assembly,
                                                     SolidFormat format) {
  static void* const symbol = module_function("cognate-solids.so", "cognate_shape_solids");
  if (!symbol) {
    return tl::unexpected(
        std::string("--format: solids need OpenCASCADE, without which Cognate was built; install "
                    "libocct-data-exchange-dev and build again, or take dxf"));
  }
  tl::expected<ShapedSolids, std::string> shaped;
  reinterpret_cast<ShapeSolids*>(symbol)(assembly, format, shaped);
  return shaped;
}

}  // namespace cognate::app
