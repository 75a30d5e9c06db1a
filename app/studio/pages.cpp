#include "app/studio/pages.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "app/studio/token.hpp"

namespace cognate::app {
namespace {

/// Every script of `page` marked as one of its own. Text of the user's cannot hold the mark's
/// place: in JSON that is embedded every '<' is escaped (see filled_page.hpp).
std::string with_nonce(std::string page, const std::string& nonce) {
  constexpr std::string_view kScript = "\n<script>\n";
  const std::string marked = fmt::format("\n<script nonce=\"{}\">\n", nonce);
  for (auto at = page.find(kScript); at != std::string::npos; at = page.find(kScript, at)) {
    page.replace(at, kScript.size(), marked);
    at += marked.size() - 1;
  }
  return page;
}

std::string policy(const std::string& nonce) {
  return fmt::format(
      "default-src 'none'; script-src 'nonce-{}' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; "
      "img-src data: blob:; media-src blob:; worker-src blob:; connect-src 'self'; "
      "frame-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'self'",
      nonce);
}

}  // namespace

HttpAnswer page_answer(std::string page) {
  const std::string nonce = random_token();
  return {
      .type = "text/html; charset=utf-8",
      .body = with_nonce(std::move(page), nonce),
      .headers = {{"Content-Security-Policy", policy(nonce)}, {"X-Frame-Options", "SAMEORIGIN"}}};
}

HttpAnswer json_answer(int status, const nlohmann::ordered_json& document) {
  using Handler = nlohmann::ordered_json::error_handler_t;
  return {.status = status,
          .type = "application/json",
          .body = document.dump(-1, ' ', false, Handler::replace)};
}

HttpAnswer error_answer(int status, const std::string& why) {
  return json_answer(status, {{"error", why}});
}

}  // namespace cognate::app
