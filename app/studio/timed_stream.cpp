#include "app/studio/timed_stream.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "app/studio/local_server.hpp"

namespace cognate::app {
namespace {

using std::chrono::milliseconds;

constexpr std::chrono::seconds kRequestTime{10}, kAnswerTime{60};
constexpr milliseconds kDrainTime{500};
/// Between two looks at whether the server is closing.
constexpr milliseconds kSlice{100};
/// Of the request line and all headers.
constexpr std::size_t kGreatestHead = 65'536;

}  // namespace

TimedStream::TimedStream(socket_t socket, const std::atomic<bool>& closing)
    : socket_(socket),
      closing_(closing),
      read_end_(Clock::now() + kRequestTime),
      allowance_(kGreatestHead + LocalServer::kGreatestBody) {}

bool TimedStream::wait(short events, Clock::time_point end) const {
  while (!closing_) {
    const auto left = std::chrono::duration_cast<milliseconds>(end - Clock::now());
    if (left.count() <= 0) return false;
    pollfd watched{.fd = socket_, .events = events, .revents = 0};
    const int ready = ::poll(&watched, 1, static_cast<int>(std::min(left, kSlice).count()));
    if (ready > 0) return true;
    if (ready < 0 && errno != EINTR) return false;
  }
  return false;
}

bool TimedStream::is_readable() const {
  return begin_ < end_ || wait(POLLIN, read_end_);
}

bool TimedStream::is_writable() const {
  return wait(POLLOUT, Clock::now() + kAnswerTime);
}

bool TimedStream::fill(Clock::time_point end) {
  const std::size_t most = std::min(buffer_.size(), allowance_);
  if (most == 0 || !wait(POLLIN, end)) return false;
  const ssize_t got = ::recv(socket_, buffer_.data(), most, 0);
  if (got <= 0) return false;
  begin_ = 0;
  end_ = static_cast<std::size_t>(got);
  allowance_ -= end_;
  return true;
}

ssize_t TimedStream::read(char* to, std::size_t size) {
  if (begin_ == end_ && !fill(read_end_)) return -1;
  const std::size_t count = std::min(size, end_ - begin_);
  std::memcpy(to, buffer_.data() + begin_, count);
  begin_ += count;
  return static_cast<ssize_t>(count);
}

ssize_t TimedStream::write(const char* from, std::size_t size) {
  if (!is_writable()) return -1;
  const ssize_t sent = ::send(socket_, from, size, MSG_NOSIGNAL | MSG_DONTWAIT);
  return sent < 0 && (errno == EAGAIN || errno == EINTR) ? 0 : sent;
}

void TimedStream::get_remote_ip_and_port(std::string& ip, int& port) const {
  ip = "127.0.0.1";
  port = 0;
}

void TimedStream::get_local_ip_and_port(std::string& ip, int& port) const {
  get_remote_ip_and_port(ip, port);
}

void TimedStream::drain() {
  allowance_ = 4 * LocalServer::kGreatestBody;
  const auto end = Clock::now() + kDrainTime;
  while (fill(end)) {
  }
}

}  // namespace cognate::app
