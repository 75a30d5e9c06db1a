/// @file A server of pages for the browser on this machine, and for no one else.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <tl/expected.hpp>

namespace cognate::app {

struct HttpRequest {
  std::string method;  ///< GET or POST
  std::string path;    ///< without its query
  std::map<std::string, std::string> query;
  std::string body;  ///< of POST: JSON, not yet looked at
};

struct HttpAnswer {
  int status = 200;
  std::string type;  ///< of the body, "application/json"
  std::string body;
  std::map<std::string, std::string> headers{};  ///< besides those of every answer
};

/// An HTTP server on 127.0.0.1. A request reaches the handler only
/// - if its Host is 127.0.0.1:PORT or localhost:PORT and its Origin, where it has one, the same: no
///   other site's page gets in, whatever its name resolves to;
/// - with the secret token, in the header X-Cognate-Token or in the query under `token`; but for a
///   path that the handler's owner declares open;
/// - if it is a GET, or a POST of JSON with a length of at most 1 MiB.
/// Whoever does not send a whole request in 10 s is cut off; connections end after one answer.
/// Answers are never cached, framed by or readable for other sites.
class LocalServer {
 public:
  using Handler = std::function<HttpAnswer(const HttpRequest& request)>;

  static constexpr std::size_t kGreatestBody = std::size_t{1} << 20;

  /// `handle` is called by many threads at once. `is_open` says whether a request without the token
  /// is handled nevertheless.
  LocalServer(std::string token, Handler handle,
              std::function<bool(const HttpRequest& request)> is_open);
  LocalServer(const LocalServer&) = delete;
  LocalServer& operator=(const LocalServer&) = delete;
  /// Stops it.
  ~LocalServer();

  /// Listens from now on, at `port` or, where that is 0, at one that is free; the port, or why not.
  tl::expected<int, std::string> start(int port);

  /// Ends every connection, those that wait for a handler once that has returned.
  void stop();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace cognate::app
