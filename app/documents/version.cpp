#include "app/documents/version.hpp"

namespace cognate::app {

std::string_view version() {
  return COGNATE_VERSION;
}

}  // namespace cognate::app
