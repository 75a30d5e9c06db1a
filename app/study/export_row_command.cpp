#include "app/commands.hpp"
namespace cognate::app {
ExitStatus export_row_command(const std::filesystem::path&, std::int64_t, const Options&) {
  return exit_bad_input;
}
}  // namespace cognate::app
