#include "app/console/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/console/interrupt.hpp"
#include "app/console/terminal.hpp"

namespace cognate::app {
namespace {

using namespace std::chrono_literals;

constexpr auto kBarDelay = 300ms;  // a run that is over by then needs no bar
constexpr auto kBarPeriod = 100ms;
constexpr auto kLinePeriod = 5s;
constexpr int kLeastBar = 6, kGreatestBar = 24;  // cells: what the words leave of the line
constexpr const char* kWipe = "\r\x1b[K";        // to the line's beginning, and erase to its end

double share_of(std::int64_t done, std::int64_t total) {
  return total > 0 ? static_cast<double>(done) / static_cast<double>(total) : 0;
}

std::string figures(double share, std::string_view words) {
  // 100 % is said of what is done, not of what is nearly done.
  const auto percent = fmt::format("{:3.0f} %", std::floor(100 * share));
  return words.empty() ? percent : fmt::format("{}  {}", percent, words);
}

}  // namespace

std::string progress_bar(double share, std::string_view words, int width) {
  const double done = std::clamp(share, 0.0, 1.0);
  const int cells = static_cast<int>(std::lround(done * width));
  return fmt::format("[{:#<{}}{:.<{}}] {}", "", cells, "", width - cells, figures(done, words));
}

std::string progress_words(std::int64_t done, std::int64_t total, double rate) {
  auto text = fmt::format("{} of {} designs", grouped(done), grouped(total));
  if (rate > 0) {
    text += fmt::format(", {}/s, {} left", rounded_rate(rate),
                        duration(static_cast<double>(total - done) / rate));
  }
  return text;
}

Progress::Progress(bool quiet, const std::atomic<bool>& stopping, double share, std::int64_t total)
    : stopping_(stopping), terminal_(error_is_terminal()), total_(total), run_(share) {
  if (!quiet) writer_ = std::thread([this] { write_until_done(); });
}

Progress::Progress(bool quiet, const std::atomic<bool>& stopping)
    : Progress(quiet, stopping, 0.0, 0) {}

Progress::Progress(bool quiet, const std::atomic<bool>& stopping, std::int64_t done,
                   std::int64_t total)
    : Progress(quiet, stopping, share_of(done, total), total) {}

Progress::~Progress() {
  if (!writer_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    is_done_ = true;
  }
  done_.notify_one();
  writer_.join();
  if (bar_shown_ && error_takes_text()) write_standard_error(kWipe);
  unfinished_line() = false;
}

void Progress::update(double share, double best) {
  const std::lock_guard lock(mutex_);
  run_.update(share, best);
}

void Progress::enter(std::string_view words, double to) {
  const std::lock_guard lock(mutex_);
  run_.enter(words, to);
}

void Progress::update(std::int64_t done) {
  update(share_of(done, total_), std::numeric_limits<double>::infinity());
}

void Progress::write_until_done() {
  std::unique_lock lock(mutex_);
  auto wait = terminal_ ? std::chrono::milliseconds(kBarDelay) : kLinePeriod;
  while (!done_.wait_for(lock, wait, [this] { return is_done_; })) {
    const std::string text = line();
    lock.unlock();  // the run, which brings news, never waits for the terminal
    show(text);
    lock.lock();
    wait = terminal_ ? std::chrono::milliseconds(kBarPeriod) : kLinePeriod;
  }
}

std::string Progress::words() const {
  if (stopping_) return terminal_ ? "stopping; Ctrl-C ends at once" : "stopping";
  const auto now = RunProgress::Clock::now();
  if (total_ == 0) return run_.words(now);
  const auto total = static_cast<double>(total_);
  return progress_words(std::llround(run_.share() * total), total_,
                        run_.rate(now).value_or(0) * total);
}

void Progress::show(const std::string& text) {
  if (!error_takes_text()) return;
  unfinished_line() = terminal_;
  write_standard_error(text);
  bar_shown_ = terminal_;
}

std::string Progress::line() const {
  if (!terminal_) return "cognate: " + figures(run_.share(), words()) + '\n';
  const auto room = error_width() - 1;
  const auto said = words();
  const auto others = static_cast<int>(progress_bar(run_.share(), said, 0).size());
  const int cells = std::clamp(static_cast<int>(room) - others, kLeastBar, kGreatestBar);
  return kWipe + progress_bar(run_.share(), said, cells).substr(0, room);
}

}  // namespace cognate::app
