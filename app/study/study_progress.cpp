#include "app/study/study_progress.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cognate::app {
namespace {

using namespace std::chrono_literals;

constexpr auto kWindow = 10s;        // over which the rate is taken
constexpr auto kMarkPeriod = 200ms;  // between two marks in it

/// Two figures of `rate`: what follows them changes all the time.
std::string rounded(double rate) {
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

}  // namespace

std::string grouped(std::int64_t count) {
  std::string text = fmt::format("{}", count);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3) {
    text.insert(static_cast<std::size_t>(at), " ");
  }
  return text;
}

std::string progress_words(std::int64_t done, std::int64_t total, double rate) {
  auto text = fmt::format("{} of {} designs", grouped(done), grouped(total));
  if (rate > 0) {
    text += fmt::format(", {}/s, {} left", rounded(rate),
                        duration(static_cast<double>(total - done) / rate));
  }
  return text;
}

StudyProgress::StudyProgress(bool quiet, std::int64_t done, std::int64_t total)
    : progress_(quiet), total_(total), recent_{{Clock::now(), done}} {}

void StudyProgress::update(std::int64_t done) {
  const auto now = Clock::now();
  if (now - recent_.back().time >= kMarkPeriod) recent_.push_back({now, done});
  while (recent_.size() > 2 && now - recent_.front().time > kWindow) recent_.pop_front();
  const double seconds = std::chrono::duration<double>(now - recent_.front().time).count();
  const double rate =
      seconds > 0 ? static_cast<double>(done - recent_.front().done) / seconds : 0.0;
  progress_.update(static_cast<double>(done) / static_cast<double>(total_),
                   progress_words(done, total_, rate));
}

}  // namespace cognate::app
