#include "app/console/rate_estimate.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cognate::app {
namespace {

using namespace std::chrono_literals;

constexpr auto kWindow = 10s;        // over which the rate is taken
constexpr auto kMarkPeriod = 200ms;  // between two marks in it
constexpr auto kLeast = 500ms;       // a shorter time says nothing

}  // namespace

void RateEstimate::mark(Clock::time_point now, double done) {
  if (marks_.size() > 1 && now - marks_[marks_.size() - 2].time < kMarkPeriod) {
    marks_.back() = {now, done};
  } else {
    marks_.push_back({now, done});
  }
  while (marks_.size() > 2 && now - marks_.front().time > kWindow) marks_.pop_front();
}

std::optional<double> RateEstimate::rate(Clock::time_point now) const {
  const double gained = marks_.back().done - marks_.front().done;
  const auto passed = now - marks_.front().time;
  if (passed < kLeast || !(gained > 0)) return std::nullopt;
  return gained / std::chrono::duration<double>(passed).count();
}

std::string rounded_rate(double rate) {
  if (rate < 10) return fmt::format("{:.2g}", rate);
  const double unit = std::pow(10.0, std::floor(std::log10(rate)) - 1);
  return grouped(static_cast<std::int64_t>(std::llround(rate / unit) * std::llround(unit)));
}

std::string duration(double seconds) {
  constexpr double kForever = 1e9;
  const auto whole = static_cast<std::int64_t>(std::min(std::ceil(seconds), kForever));
  const auto minutes = whole / 60;
  constexpr std::int64_t kDay = 24 * 60;
  if (minutes < 60) return fmt::format("{}:{:02}", minutes, whole % 60);
  if (minutes < 2 * kDay) return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
  return fmt::format("{} days", minutes / kDay);
}

std::string grouped(std::int64_t count) {
  std::string text = fmt::format("{}", count);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3) {
    text.insert(static_cast<std::size_t>(at), " ");
  }
  return text;
}

}  // namespace cognate::app
