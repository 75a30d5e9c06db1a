/// @file What the values of options have in common: how a text is read whole, how one is refused.
#pragma once

#include <fmt/core.h>

#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <tl/expected.hpp>

namespace cognate::app {

/// The number that all of `text` spells.
template <class Number>
std::optional<Number> parse_all(std::string_view text) {
  Number value{};
  const char* begin = std::to_address(text.begin());
  const char* end = begin + text.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  return error == std::errc{} && stop == end ? std::optional(value) : std::nullopt;
}

inline tl::unexpected<std::string> refusal(std::string_view option, std::string_view text,
                                           std::string_view allowed) {
  return tl::unexpected(
      fmt::format("{}: '{}' is not possible; allowed is {}", option, text, allowed));
}

}  // namespace cognate::app
