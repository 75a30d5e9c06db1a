#include "app/studio/local_server.hpp"

#include <fmt/core.h>
#include <httplib.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "app/studio/connections.hpp"
#include "app/studio/timed_stream.hpp"
#include "app/studio/token.hpp"

namespace cognate::app {
namespace {

constexpr const char* kLoopback = "127.0.0.1";
constexpr std::size_t kLongestPath = 256;

/// For whom an answer is: this page alone, now alone, as what it says that it is.
const httplib::Headers kAnswerHeaders = {{"Cache-Control", "no-store"},
                                         {"Cross-Origin-Opener-Policy", "same-origin"},
                                         {"Cross-Origin-Resource-Policy", "same-origin"},
                                         {"Referrer-Policy", "no-referrer"},
                                         {"X-Content-Type-Options", "nosniff"}};

void refuse(httplib::Response& response, int status, std::string_view why) {
  response.status = status;
  response.set_content(fmt::format(R"({{"error":"{}"}})", why), "application/json");
}

/// Why a request whose head alone has come is refused.
struct Refusal {
  int status;
  const char* why;
};

Refusal none() {
  return {0, ""};
}

/// Of a POST. What has no length, or is packed, could be of any size.
Refusal refusal_of_body(const httplib::Request& request) {
  const std::string type = request.get_header_value("Content-Type");
  if (std::string_view(type).substr(0, type.find(';')) != "application/json") {
    return {415, "expected application/json"};
  }
  if (request.has_header("Transfer-Encoding") || request.has_header("Content-Encoding")) {
    return {411, "expected a plain body of a given length"};
  }
  const std::string text = request.get_header_value("Content-Length");
  std::size_t length = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), length);
  const bool too_large = error == std::errc::result_out_of_range ||
                         (error == std::errc() && length > LocalServer::kGreatestBody);
  if (too_large) return {413, "larger than 1 MiB"};
  if (error != std::errc() || end != text.data() + text.size()) {
    return {411, "expected a plain body of a given length"};
  }
  return none();
}

HttpRequest request_of(const httplib::Request& request) {
  return {.method = request.method,
          .path = request.path,
          .query = {request.params.begin(), request.params.end()},
          .body = request.body};
}

}  // namespace

/// The library's server with this one's streams.
class LoopbackServer final : public httplib::Server {
 public:
  std::atomic<bool> closing{false};

 private:
  bool process_and_close_socket(socket_t socket) override {
    TimedStream stream(socket, closing);
    bool closed = false;
    const bool served = process_request(stream, true, closed, nullptr);
    ::shutdown(socket, SHUT_WR);
    stream.drain();
    ::close(socket);
    return served;
  }
};

struct LocalServer::Parts {
  std::string token;
  Handler handle;
  std::function<bool(const HttpRequest&)> is_open;
  LoopbackServer server{};
  int port = 0;
  std::thread thread{};

  Refusal refusal_of(const httplib::Request& request) const;
  bool is_of_this_machine(std::string_view host) const;
  bool knows_token(const httplib::Request& request) const;
  void answer(const httplib::Request& request, httplib::Response& response) const;
  void route();
};

bool LocalServer::Parts::is_of_this_machine(std::string_view host) const {
  return host == fmt::format("{}:{}", kLoopback, port) || host == fmt::format("localhost:{}", port);
}

bool LocalServer::Parts::knows_token(const httplib::Request& request) const {
  const bool in_header = request.has_header("X-Cognate-Token");
  const std::string given =
      in_header ? request.get_header_value("X-Cognate-Token") : request.get_param_value("token");
  return is_same_secret(given, token);
}

Refusal LocalServer::Parts::refusal_of(const httplib::Request& request) const {
  if (request.get_header_value_count("Host") != 1 ||
      !is_of_this_machine(request.get_header_value("Host"))) {
    return {403, "wrong Host"};
  }
  if (request.has_header("Origin")) {
    constexpr std::string_view kScheme = "http://";
    const std::string origin = request.get_header_value("Origin");
    const bool same = origin.starts_with(kScheme) &&
                      is_of_this_machine(std::string_view(origin).substr(kScheme.size()));
    if (!same || request.get_header_value_count("Origin") != 1) return {403, "wrong Origin"};
  }
  if (!knows_token(request) && !is_open(request_of(request))) {
    return {403, "wrong or missing token; open the address that cognate studio printed"};
  }
  if (request.method != "GET" && request.method != "POST") return {405, "expected GET or POST"};
  if (request.path.size() > kLongestPath) return {404, "no such page"};
  // An answer in overlapping parts could be many times as large.
  if (request.has_header("Range")) return {400, "no part of an answer can be had"};
  return request.method == "POST" ? refusal_of_body(request) : none();
}

void LocalServer::Parts::answer(const httplib::Request& request,
                                httplib::Response& response) const {
  auto answered = handle(request_of(request));
  response.status = answered.status;
  for (const auto& [name, value] : answered.headers) response.set_header(name, value);
  const auto body = std::make_shared<const std::string>(std::move(answered.body));
  if (body->empty()) return;
  // By a provider, since the library would compress a body, which takes seconds for a large page.
  response.set_content_provider(
      body->size(), answered.type,
      [body](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
        return sink.write(body->data() + offset, length);
      });
}

void LocalServer::Parts::route() {
  using Handled = httplib::Server::HandlerResponse;
  const auto serve = [this](const httplib::Request& request, httplib::Response& response) {
    answer(request, response);
  };
  // Not shared with another server, as the library would have it.
  server.set_socket_options([](socket_t socket) {
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  server.new_task_queue = [] { return new Connections; };
  server.set_default_headers(kAnswerHeaders);
  server.set_pre_routing_handler([this](const auto& request, auto& response) {
    const Refusal refusal = refusal_of(request);
    if (refusal.status == 0) return Handled::Unhandled;
    refuse(response, refusal.status, refusal.why);
    return Handled::Handled;
  });
  server.Get(".*", serve).Post(".*", serve);
  server.set_exception_handler([](const auto&, auto& response, const auto&) {
    refuse(response, 500, "a fault of Cognate's own");
  });
  server.set_error_handler([](const httplib::Request&, httplib::Response& response) {
    if (!response.has_header("Content-Type")) {
      refuse(response, response.status, "the request cannot be understood");
    }
  });
  server.set_payload_max_length(kGreatestBody);
}

LocalServer::LocalServer(std::string token, Handler handle,
                         std::function<bool(const HttpRequest& request)> is_open)
    : parts_(new Parts{std::move(token), std::move(handle), std::move(is_open)}) {}

LocalServer::~LocalServer() {
  stop();
}

tl::expected<int, std::string> LocalServer::start(int port) {
  Parts& parts = *parts_;
  parts.route();
  const bool bound = port == 0 ? (parts.port = parts.server.bind_to_any_port(kLoopback)) > 0
                               : parts.server.bind_to_port(kLoopback, port);
  if (!bound) {
    return tl::unexpected(fmt::format("cannot listen at {}:{}: {}", kLoopback, port,
                                      std::generic_category().message(errno)));
  }
  if (port != 0) parts.port = port;
  parts.thread = std::thread([&parts] { parts.server.listen_after_bind(); });
  while (!parts.server.is_running()) std::this_thread::yield();  // else a stop would pass it by
  return parts.port;
}

void LocalServer::stop() {
  if (!parts_->thread.joinable()) return;
  parts_->server.closing = true;
  parts_->server.stop();
  parts_->thread.join();
}

}  // namespace cognate::app
