/// @file Pages as the studio serves them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/studio/local_server.hpp"

namespace cognate::app {

/// `page`, whose own scripts run and no other, which talks to this server and no other, and which
/// no page but this server's may frame.
HttpAnswer page_answer(std::string page);

/// `document` as JSON with an HTTP status.
HttpAnswer json_answer(int status, const nlohmann::ordered_json& document);

/// {"error": why}.
HttpAnswer error_answer(int status, const std::string& why);

}  // namespace cognate::app
