#include "app/study/cache_folder.hpp"

#include <cstdlib>

namespace cognate::app {

std::filesystem::path cache_folder() {
  const auto of = [](const char* variable) {
    const char* value = std::getenv(variable);
    const std::filesystem::path path = value ? value : "";
    return path.is_absolute() ? path : std::filesystem::path();
  };
  if (const auto caches = of("XDG_CACHE_HOME"); !caches.empty()) return caches / "cognate";
  if (const auto home = of("HOME"); !home.empty()) return home / ".cache" / "cognate";
  if (const auto local = of("LOCALAPPDATA"); !local.empty()) return local / "cognate";
  return {};
}

}  // namespace cognate::app
