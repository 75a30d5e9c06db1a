/// @file A connection that cannot be held open by sending nothing, or little by little.
#pragma once

#include <httplib.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>

namespace cognate::app {

/// What a client sends within a time and up to a number of bytes, and what it takes within a time.
class TimedStream final : public httplib::Stream {
 public:
  /// Of the connected `socket`; reading and writing end where `closing` is raised.
  TimedStream(socket_t socket, const std::atomic<bool>& closing);

  bool is_readable() const override;
  bool is_writable() const override;
  ssize_t read(char* to, std::size_t size) override;
  ssize_t write(const char* from, std::size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;
  socket_t socket() const override { return socket_; }

  /// Takes what the client still sends and throws it away, for a short while: a connection closed
  /// before would be reset, and its answer lost.
  void drain();

 private:
  using Clock = std::chrono::steady_clock;

  /// Waits until the socket is ready for `events`; false where `end` came first.
  bool wait(short events, Clock::time_point end) const;
  bool fill(Clock::time_point end);

  socket_t socket_;
  const std::atomic<bool>& closing_;
  Clock::time_point read_end_;
  std::size_t allowance_;  ///< bytes that may still come
  std::array<char, 4096> buffer_{};
  std::size_t begin_ = 0, end_ = 0;  ///< what of the buffer is to be read
};

}  // namespace cognate::app
