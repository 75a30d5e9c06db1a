#include "app/progress.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/terminal.hpp"

namespace cognate::app {
namespace {

using namespace std::chrono_literals;

constexpr auto kBarDelay = 300ms;  // a run that is over by then needs no bar
constexpr auto kBarPeriod = 100ms;
constexpr auto kLinePeriod = 5s;
constexpr int kBarWidth = 30;
constexpr const char* kWipe = "\r\x1b[K";  // to the line's beginning, and erase to its end

std::string best_words(double best) {
  return std::isfinite(best) ? fmt::format("best {:.3g}", best) : "";
}

std::string figures(double share, std::string_view words) {
  const auto percent = fmt::format("{:3.0f} %", 100 * share);
  return words.empty() ? percent : fmt::format("{}  {}", percent, words);
}

}  // namespace

std::string progress_bar(double share, std::string_view words, int width) {
  const double done = std::clamp(share, 0.0, 1.0);
  const int cells = static_cast<int>(std::lround(done * width));
  return fmt::format("[{:#<{}}{:.<{}}] {}", "", cells, "", width - cells, figures(done, words));
}

std::string progress_bar(double share, double best, int width) {
  return progress_bar(share, best_words(best), width);
}

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(error_is_terminal()) {
  next_ = Clock::now();
  if (terminal_) {
    next_ += kBarDelay;
  } else {
    next_ += kLinePeriod;
  }
}

Progress::~Progress() {
  if (bar_shown_) write_standard_error(kWipe);
}

void Progress::update(double share, double best) {
  update(share, best_words(best));
}

void Progress::update(double share, std::string_view words) {
  const auto now = Clock::now();
  if (quiet_ || now < next_) return;
  if (terminal_) {
    write_standard_error(kWipe + progress_bar(share, words, kBarWidth));
    bar_shown_ = true;
    next_ = now + kBarPeriod;
  } else {
    write_standard_error("cognate: " + figures(std::clamp(share, 0.0, 1.0), words) + '\n');
    next_ = now + kLinePeriod;
  }
}

}  // namespace cognate::app
