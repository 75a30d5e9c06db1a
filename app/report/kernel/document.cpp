#include "app/report/kernel/document.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "app/report/kernel/numbers.hpp"

namespace cognate::page {
namespace {

using problems::reading::Array;
using problems::reading::Node;
using problems::reading::Table;

/// Reads values one after the other. Nothing is faulted: the page has written them.
class Values {
 public:
  explicit Values(std::string_view text) : text_(text) {}

  // A document nests as deep as a file may.
  // NOLINTNEXTLINE(misc-no-recursion)
  Node next() {
    Node node;
    switch (take()) {
      case '#':
        node.value = numbers()[number_++];
        break;
      case 'i':
        node.value = static_cast<std::int64_t>(numbers()[number_++]);
        break;
      case '+':
        node.value = true;
        break;
      case '-':
        node.value = false;
        break;
      case 's':
        node.value = text();
        break;
      case 'a':
        node.value = array();
        break;
      default:
        node.value = table();
    }
    return node;
  }

  // NOLINTNEXTLINE(misc-no-recursion)
  Table table() {
    Table entries(count());
    for (auto& entry : entries) {
      take();
      entry.key = text();
      entry.node = next();
    }
    return entries;
  }

  char take() { return at_ < text_.size() ? text_[at_++] : '\0'; }

 private:
  std::size_t count() {
    std::size_t count = 0;
    for (char digit = take(); digit >= '0' && digit <= '9'; digit = take()) {
      count = 10 * count + static_cast<std::size_t>(digit - '0');
    }
    return count;
  }

  std::string text() {
    const std::size_t length = count();
    const std::size_t begin = std::exchange(at_, at_ + length);
    return std::string(text_.substr(begin, length));
  }

  // NOLINTNEXTLINE(misc-no-recursion)
  Array array() {
    Array entries(count());
    for (Node& entry : entries) entry = next();
    return entries;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
};

}  // namespace

Table document_of(std::string_view text) {
  Values values(text);
  values.take();
  return values.table();
}

}  // namespace cognate::page
