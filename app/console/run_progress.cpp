#include "app/console/run_progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cognate::app {
namespace {

constexpr double kQuiet = 2;  // seconds without news after which the time that has passed is some

}  // namespace

std::string share_words(const RunPart& part, double share, std::optional<double> rate,
                        double passed, std::string_view best) {
  std::vector<std::string> words;
  if (!part.words.empty()) words.push_back(part.words);
  const bool is_known = std::isfinite(part.end);
  if (is_known && rate && *rate > 0) {
    const double left = std::max(0.0, part.end - share) / *rate;
    words.push_back(fmt::format("{} left{}", duration(left), part.end < 1 ? " of it" : ""));
    words.push_back(fmt::format("{} %/s", rounded_rate(100 * *rate)));
  } else if (!is_known || passed >= kQuiet) {
    words.push_back(fmt::format("{} so far", duration(passed)));
  }
  if (!best.empty()) words.emplace_back(best);
  return fmt::format("{}", fmt::join(words, ", "));
}

RunProgress::RunProgress(double share)
    : share_(share),
      best_(std::numeric_limits<double>::infinity()),
      rate_estimate_(Clock::now(), share) {}

void RunProgress::update(double share, double best) {
  share_ = std::max(share_, std::clamp(share, 0.0, 1.0));
  if (std::isfinite(best)) best_ = best;
  rate_estimate_.mark(Clock::now(), share_);
}

void RunProgress::enter(std::string_view words, double to) {
  const auto now = Clock::now();
  part_ = {std::string(words), to, now};
  rate_estimate_ = RateEstimate(now, share_);  // the last part says nothing of this one
}

std::optional<double> RunProgress::left(Clock::time_point now) const {
  const auto rate = rate_estimate_.rate(now);
  if (!std::isfinite(part_.end) || !rate || !(*rate > 0)) return std::nullopt;
  return std::max(0.0, part_.end - share_) / *rate;
}

double RunProgress::seconds_in_part(Clock::time_point now) const {
  return std::chrono::duration<double>(now - part_.begun).count();
}

std::string RunProgress::words(Clock::time_point now) const {
  const std::string best = std::isfinite(best_) ? fmt::format("best {:.3g}", best_) : "";
  return share_words(part_, share_, rate(now), seconds_in_part(now), best);
}

}  // namespace cognate::app
