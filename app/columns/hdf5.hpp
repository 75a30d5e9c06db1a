/// @file HDF5's objects as objects that close themselves, its errors as exceptions of this module.
#pragma once

#include <hdf5.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace cognate::app {

/// What HDF5 says went wrong.
class Hdf5Error : public std::runtime_error {
 public:
  Hdf5Error(const std::string& what, int system) : std::runtime_error(what), system_(system) {}
  int system() const { return system_; }  ///< the errno, 0 where it was nothing of the system

 private:
  int system_;
};

/// Keeps HDF5 from printing its errors, and from writing once more, and crashing, at the end of the
/// program what a full disk refused. Before anything else.
void begin_hdf5();

/// Throws the innermost of the errors that HDF5 has heaped up.
[[noreturn]] void throw_hdf5_error();

template <class Result>
Result checked(Result result) {
  if (result < 0) throw_hdf5_error();
  return result;
}

/// An object of HDF5, which `close` gives back.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(checked(id)), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }
  /// Closes it now, when what is still to be written may fail.
  void close() { checked(close_(std::exchange(id_, -1))); }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Words of `bytes` bytes in UTF-8.
Handle word_type(std::size_t bytes);

/// The space of a list.
Handle line_of(hsize_t length);

/// How a file is opened: without locks, which some file systems do not have.
Handle unlocked_access();

}  // namespace cognate::app
