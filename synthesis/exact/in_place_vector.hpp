/// @file A handful of values without the heap.
#pragma once

#include <array>
#include <cstddef>

namespace cognate::synthesis {

/// Up to `Most` values in the order they were added.
template <class T, std::size_t Most>
class InPlaceVector {
 public:
  /// Adds a value; there must be room.
  void push_back(const T& value) { values_[count_++] = value; }

  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  const T& operator[](std::size_t i) const { return values_[i]; }
  T& operator[](std::size_t i) { return values_[i]; }
  const T* begin() const { return values_.data(); }
  const T* end() const { return values_.data() + count_; }
  T* begin() { return values_.data(); }
  T* end() { return values_.data() + count_; }

 private:
  std::array<T, Most> values_{};
  std::size_t count_ = 0;
};

}  // namespace cognate::synthesis
