#include "app/console/options.hpp"

#include <fmt/core.h>

#include "app/console/option_text.hpp"

namespace cognate::app {
namespace {

constexpr std::uint64_t kGreatestSeed = (std::uint64_t{1} << 53) - 1;
constexpr int kMostThreads = 1024;
constexpr double kLongestTime = 1e9;  // seconds; far within what clocks count in nanoseconds

}  // namespace

tl::expected<std::uint64_t, std::string> parse_seed(std::string_view text) {
  const auto seed = parse_all<std::uint64_t>(text);
  if (!seed || *seed > kGreatestSeed) {
    return refusal("--seed", text, fmt::format("a whole number from 0 to {}", kGreatestSeed));
  }
  return *seed;
}

tl::expected<int, std::string> parse_threads(std::string_view text) {
  const auto threads = parse_all<int>(text);
  if (!threads || *threads < 1 || *threads > kMostThreads) {
    return refusal("--threads", text, fmt::format("a whole number from 1 to {}", kMostThreads));
  }
  return *threads;
}

tl::expected<int, std::string> parse_steps(std::string_view text) {
  constexpr int kMostSteps = 100'000;
  const auto steps = parse_all<int>(text);
  if (steps && *steps >= 1 && *steps <= kMostSteps) return *steps;
  return refusal("--steps", text, fmt::format("a whole number from 1 to {}", kMostSteps));
}

tl::expected<int, std::string> parse_sample(std::string_view text) {
  constexpr int kMostBoxes = 1'000'000;
  const auto boxes = parse_all<int>(text);
  if (boxes && *boxes >= 1 && *boxes <= kMostBoxes) return *boxes;
  return refusal("--sample", text, fmt::format("a whole number from 1 to {}", kMostBoxes));
}

tl::expected<double, std::string> parse_time_limit(std::string_view text) {
  const auto seconds = parse_all<double>(text);
  if (!seconds || !(*seconds > 0 && *seconds <= kLongestTime)) {
    return refusal("--time-limit", text,
                   fmt::format("a number of seconds above 0, at most {}", kLongestTime));
  }
  return *seconds;
}

tl::expected<problems::LengthUnit, std::string> parse_length_unit(std::string_view text) {
  const auto unit = problems::from_string<problems::LengthUnit>(text);
  if (unit) return *unit;
  return refusal("--length-unit", text, "mm, cm, m or in");
}

tl::expected<std::filesystem::path, std::string> parse_folder(std::string_view text) {
  if (text.empty()) return refusal("--out", text, "the name of a folder");
  return std::filesystem::path(text);
}

}  // namespace cognate::app
