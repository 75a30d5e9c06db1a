#include "app/documents/module.hpp"

#include <dlfcn.h>

#include <array>
#include <filesystem>
#include <system_error>

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

/// The folders of the program and of the object that this function is in.
std::array<fs::path, 2> own_folders() {
  std::error_code error;
  Dl_info object{};
  const bool known = ::dladdr(reinterpret_cast<const void*>(&own_folders), &object) != 0;
  return {fs::read_symlink("/proc/self/exe", error).parent_path(),
          known ? fs::path(object.dli_fname).parent_path() : fs::path()};
}

}  // namespace

void* module_function(const char* module, const char* name) {
  for (const fs::path& folder : own_folders()) {
    for (const char* from_there : {"", COGNATE_MODULES_FROM_PROGRAM, COGNATE_MODULES_FROM_PYTHON,
                                   COGNATE_MODULES_FROM_BUILT_PYTHON}) {
      void* const opened = ::dlopen((folder / from_there / module).c_str(), RTLD_NOW | RTLD_LOCAL);
      if (opened != nullptr) return ::dlsym(opened, name);
    }
  }
  return nullptr;
}

}  // namespace cognate::app
