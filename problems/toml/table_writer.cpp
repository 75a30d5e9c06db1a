#include "problems/toml/table_writer.hpp"

#include <algorithm>
#include <iterator>

#include "problems/basics/degrees.hpp"

namespace cognate::problems::reading {

Node node(bool value) {
  return {.value = value};
}

Node node(int value) {
  return {.value = std::int64_t{value}};
}

Node node(double value) {
  return {.value = value};
}

Node node(std::string_view text) {
  return {.value = std::string(text)};
}

Node node(const Vec2d& point) {
  return node(Array{node(point.x), node(point.y)});
}

Node node(const Range& range) {
  return node(Array{node(range.min), node(range.max)});
}

Node node(const Box& box) {
  return node(Array{node(box.min), node(box.max)});
}

Node node(Array array) {
  return {.value = std::move(array)};
}

Node node(Table table) {
  return {.value = std::move(table)};
}

Node node_deg(double angle) {
  return node(degrees(angle));
}

Node node_deg(const Range& range) {
  return node(Range{degrees(range.min), degrees(range.max)});
}

TableWriter& TableWriter::add(std::string_view key, Node value) {
  table_.push_back({.key = std::string(key), .where = {}, .node = std::move(value)});
  return *this;
}

TableWriter& TableWriter::append(Table entries) {
  std::ranges::move(entries, std::back_inserter(table_));
  return *this;
}

}  // namespace cognate::problems::reading
