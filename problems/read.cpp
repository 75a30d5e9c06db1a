#include "problems/read.hpp"

#include "problems/task_document.hpp"

namespace cognate::problems {
namespace {

using Faults = std::vector<Fault>;

tl::expected<Task, Faults> without_place(TaskAt read) {
  return std::move(read.task);
}

}  // namespace

tl::expected<TaskAt, Faults> parse_task_at(std::string_view text) {
  return reading::read_text(text).and_then(
      [](const reading::Table& document) { return reading::read_task(document, {}); });
}

tl::expected<TaskAt, Faults> read_task_at(const std::filesystem::path& file,
                                          std::optional<LengthUnit> length_unit) {
  return reading::read_source(file).and_then([&](const reading::Source& source) {
    return reading::with_length_unit(source.document, length_unit)
        .and_then([&](const reading::Table& document) {
          return reading::read_task(document, source.folder);
        });
  });
}

tl::expected<Task, Faults> parse_task(std::string_view text) {
  return parse_task_at(text).and_then(without_place);
}

tl::expected<Task, Faults> read_task(const std::filesystem::path& file) {
  return read_task_at(file).and_then(without_place);
}

}  // namespace cognate::problems
