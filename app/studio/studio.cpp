#include "app/studio/studio.hpp"

#include <fmt/core.h>

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "app/console/interrupt.hpp"
#include "app/console/option_text.hpp"
#include "app/documents/result_json.hpp"
#include "app/studio/browser.hpp"
#include "app/studio/edited_file.hpp"
#include "app/studio/local_server.hpp"
#include "app/studio/routes.hpp"
#include "app/studio/token.hpp"

namespace cognate::app {
namespace {

constexpr std::chrono::milliseconds kLookAtFile{100};

ExitStatus complain_about(const std::string& what) {
  complain(what);
  return exit_bad_input;
}

ExitStatus print_address(const std::string& address, const Options& options) {
  if (options.json) {
    return print(write_json({{"format", "cognate-studio/1"}, {"address", address}}));
  }
  return print(address + "\n" + (options.quiet ? "" : "Ctrl-C ends the studio.\n"));
}

}  // namespace

tl::expected<int, std::string> parse_port(std::string_view text) {
  constexpr int kGreatestPort = 65535;
  const auto port = parse_all<int>(text);
  if (port && *port >= 1 && *port <= kGreatestPort) return *port;
  return refusal("--port", text, fmt::format("a whole number from 1 to {}", kGreatestPort));
}

ExitStatus studio_command(const StudioOptions& studio, const Options& options) {
  const auto& interrupted = catch_interrupts();
  std::unique_ptr<EditedFile> file;
  if (studio.file) {
    auto opened = EditedFile::open(*studio.file);
    if (!opened) return complain_about(opened.error());
    file = std::move(*opened);
  }
  const std::string token = random_token();
  StudioRoutes routes(token, std::move(file), options);
  LocalServer server(
      token, [&](const HttpRequest& request) { return routes.answer(request); },
      [&](const HttpRequest& request) { return routes.is_invitation(request); });
  const auto port = server.start(studio.port);
  if (!port) return complain_about(port.error());

  const std::string begin = fmt::format("http://127.0.0.1:{}", *port);
  const ExitStatus printed = print_address(begin + "/?token=" + token, options);
  if (printed != exit_done) return printed;
  if (studio.opens_browser) open_in_browser(begin + routes.invite());
  while (!interrupted) {
    std::this_thread::sleep_for(kLookAtFile);
    routes.look_at_file();
  }
  routes.close();
  server.stop();
  return exit_done;
}

}  // namespace cognate::app
