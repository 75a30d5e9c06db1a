#include "app/export/solids.hpp"

#include <dlfcn.h>

#include <array>
#include <filesystem>
#include <system_error>

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kModule = "cognate-solids.so";

/// The folders of the program and of the object that this function is in.
std::array<fs::path, 2> own_folders() {
  std::error_code error;
  Dl_info object{};
  const bool known = ::dladdr(reinterpret_cast<const void*>(&own_folders), &object) != 0;
  return {fs::read_symlink("/proc/self/exe", error).parent_path(),
          known ? fs::path(object.dli_fname).parent_path() : fs::path()};
}

/// The module where the build or the installation puts it; null where it is in neither place.
void* open_module() {
  for (const fs::path& folder : own_folders()) {
    for (const fs::path& place :
         {folder / kModule, folder / COGNATE_SOLIDS_FROM_PROGRAM / kModule}) {
      if (void* module = ::dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL)) return module;
    }
  }
  return nullptr;
}

}  // namespace

SolidLoop circle_loop(const Vec2d& centre, double radius) {
  return {{}, centre, radius};
}

tl::expected<ShapedSolids, std::string> shape_solids(const SolidAssembly& assembly,
                                                     SolidFormat format) {
  static void* const module = open_module();
  void* const symbol = module ? ::dlsym(module, "cognate_shape_solids") : nullptr;
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
