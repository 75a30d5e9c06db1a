#include "app/study/block_message.hpp"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>

namespace cognate::app {
namespace {

using problems::Cell;
using problems::StudyBlock;

class Writer {
 public:
  template <class Value>
  void put(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    put_bytes(&value, sizeof value);
  }

  template <class Value>
  void put_all(const std::vector<Value>& values) {
    static_assert(std::is_trivially_copyable_v<Value>);
    put(values.size());
    put_bytes(values.data(), values.size() * sizeof(Value));
  }

  void put(const std::string& text) {
    put(text.size());
    put_bytes(text.data(), text.size());
  }

  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  void put_bytes(const void* from, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(from);
    bytes_.insert(bytes_.end(), first, first + size);
  }

  std::vector<std::byte> bytes_;
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class Value>
  Value get() {
    Value value;
    std::memcpy(&value, next(sizeof value), sizeof value);
    return value;
  }

  template <class Value>
  std::vector<Value> get_all() {
    const auto count = get<std::size_t>();
    if (count > bytes_.size() / sizeof(Value)) throw_short();
    std::vector<Value> values(count);
    if (count > 0) std::memcpy(values.data(), next(count * sizeof(Value)), count * sizeof(Value));
    return values;
  }

  std::string get_text() {
    const auto size = get<std::size_t>();
    return {reinterpret_cast<const char*>(next(size)), size};
  }

 private:
  [[noreturn]] static void throw_short() {
    throw std::out_of_range("a message between processes is too short");
  }

  const std::byte* next(std::size_t size) {
    if (size > bytes_.size()) throw_short();
    const auto* first = bytes_.data();
    bytes_ = bytes_.subspan(size);
    return first;
  }

  std::span<const std::byte> bytes_;
};

}  // namespace

std::vector<std::byte> block_message(const StudyBlock& block) {
  Writer writer;
  writer.put(block.first);
  writer.put(block.count);
  writer.put(block.filtered);
  writer.put_all(block.ids);
  writer.put_all(block.statuses);
  writer.put(block.cells.size());
  for (const Cell& cell : block.cells) {
    writer.put(static_cast<std::uint8_t>(cell.index()));
    if (const auto* number = std::get_if<double>(&cell)) writer.put(*number);
    if (const auto* text = std::get_if<std::string>(&cell)) writer.put(*text);
  }
  return writer.take();
}

StudyBlock block_of(std::span<const std::byte> message) {
  Reader reader(message);
  StudyBlock block{.first = reader.get<std::int64_t>(),
                   .count = reader.get<std::int64_t>(),
                   .filtered = reader.get<std::int64_t>(),
                   .ids = reader.get_all<std::int64_t>(),
                   .statuses = reader.get_all<problems::RunStatus>()};
  for (auto left = reader.get<std::size_t>(); left > 0; --left) {
    switch (reader.get<std::uint8_t>()) {
      case 0:
        block.cells.emplace_back();
        break;
      case 1:
        block.cells.emplace_back(reader.get<double>());
        break;
      default:
        block.cells.emplace_back(reader.get_text());
    }
  }
  return block;
}

}  // namespace cognate::app
