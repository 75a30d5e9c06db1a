/// @file `cognate studio`: a page in which a problem is edited, solved by this program and shown.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "app/console/messages.hpp"
#include "app/console/options.hpp"

namespace cognate::app {

struct StudioOptions {
  std::optional<std::filesystem::path> file;  ///< to be edited; none: a text that the page saves
  int port = 0;                               ///< 0: one that is free
  bool opens_browser = true;
};

/// A port from 1 to 65535; the error says what is allowed.
tl::expected<int, std::string> parse_port(std::string_view text);

/// Serves the page to this machine until an interrupt, and prints its address (with `--json` as a
/// document `cognate-studio/1`). The status is that of bad input where the file cannot be edited or
/// the port not be had.
ExitStatus studio_command(const StudioOptions& studio, const Options& options);

}  // namespace cognate::app
