#include "problems/study/base.hpp"

#include <algorithm>
#include <cmath>

#include "problems/study/key_path.hpp"
#include "problems/task_document.hpp"

namespace cognate::problems {

struct StudyBase::Document {
  reading::Table table;
  std::filesystem::path folder;
  struct Place {
    reading::Node* node = nullptr;
    bool integer = false;
  };
  std::vector<Place> places;  ///< of each variable
};

namespace {

/// Puts the path data in the place of the file that they were read from, so that rows depend on no
/// file but the base.
void hold_drawing(reading::Table& document, const std::string& path_data) {
  const auto found = std::ranges::find(document, "target", &reading::Entry::key);
  if (found == document.end()) return;
  auto& target = std::get<reading::Table>(found->node.value);
  const auto svg = std::ranges::find(target, "svg", &reading::Entry::key);
  if (svg == target.end()) return;
  svg->key = "svg_path";
  svg->node.value = path_data;
  std::erase_if(target, [](const reading::Entry& entry) { return entry.key == "svg_id"; });
}

}  // namespace

bool is_whole(double value) {
  return value == std::trunc(value) && std::abs(value) <= 0x1p53;
}

StudyBase::StudyBase(const Study& study) : document_(std::make_unique<Document>()) {
  auto table = reading::read_text(study.base_text);
  if (table) document_->table = *std::move(table);
  document_->folder = study.folder;
  if (!study.drawing.empty()) hold_drawing(document_->table, study.drawing);
  for (const StudyVariable& variable : study.variables) {
    auto* node = reading::find_node(document_->table, variable.path);
    const bool integer = node && std::holds_alternative<std::int64_t>(node->value);
    document_->places.push_back({node, integer});
  }
}

StudyBase::~StudyBase() = default;
StudyBase::StudyBase(StudyBase&&) noexcept = default;
StudyBase& StudyBase::operator=(StudyBase&&) noexcept = default;

tl::expected<Task, std::vector<Fault>> StudyBase::with(std::span<const double> values) {
  for (std::size_t i = 0; i < document_->places.size(); ++i) {
    const auto& [node, integer] = document_->places[i];
    if (!node) continue;
    if (integer && is_whole(values[i])) {
      node->value = static_cast<std::int64_t>(values[i]);
    } else {
      node->value = values[i];
    }
  }
  return reading::read_task(document_->table, document_->folder).map([](TaskAt read) {
    return std::move(read.task);
  });
}

}  // namespace cognate::problems
