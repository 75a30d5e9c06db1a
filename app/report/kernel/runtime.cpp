/// @file What the C++ library and others ask of their surroundings. A page has no output and
/// nothing to catch an exception with: where memory ends, or a library finds a fault or throws, the
/// module stops, which the page sees as an error of the call.
#include <__verbose_abort>
#include <boost/throw_exception.hpp>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {
void* taken(std::size_t size) {
  void* room = std::malloc(size > 0 ? size : 1);
  if (room == nullptr) __builtin_trap();
  return room;
}
}  // namespace

void* operator new(std::size_t size) {
  return taken(size);
}
void* operator new[](std::size_t size) {
  return taken(size);
}
void operator delete(void* room) noexcept {
  std::free(room);
}
void operator delete[](void* room) noexcept {
  std::free(room);
}
void operator delete(void* room, std::size_t) noexcept {
  std::free(room);
}
void operator delete[](void* room, std::size_t) noexcept {
  std::free(room);
}

void std::__libcpp_verbose_abort(const char*, ...) {
  __builtin_trap();
}

void boost::throw_exception(const std::exception&, const source_location&) {
  __builtin_trap();
}

extern "C" void* __cxa_allocate_exception(std::size_t) noexcept {
  __builtin_trap();
}

extern "C" [[noreturn]] void __cxa_throw(void*, void*, void (*)(void*)) {
  __builtin_trap();
}

/// A page has no clock: what it calls has no deadline.
std::chrono::steady_clock::time_point std::chrono::steady_clock::now() noexcept {
  return {};
}

extern "C" void abort() {
  __builtin_trap();
}

// Nor has it files: what a library writes to its error output goes nowhere.
extern "C" {
constexpr int kNoSuchFile = 8;  // EBADF of WASI
int __imported_wasi_snapshot_preview1_fd_write(int, int, int, int) {
  return kNoSuchFile;
}
int __imported_wasi_snapshot_preview1_fd_seek(int, long long, int, int) {
  return kNoSuchFile;
}
int __imported_wasi_snapshot_preview1_fd_close(int) {
  return kNoSuchFile;
}
}
