#include "problems/study/study_base.hpp"

#include <cmath>

#include "problems/reading/key_path.hpp"
#include "problems/reading/task_document.hpp"

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

bool is_whole(double value) {
  return value == std::trunc(value) && std::abs(value) <= 0x1p53;
}

StudyBase::StudyBase(const Study& study) : document_(std::make_unique<Document>()) {
  auto table = reading::read_text(study.base_text);
  if (table) document_->table = *std::move(table);
  document_->folder = study.folder;
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
  return reading::read_task(document_->table, document_->folder).map([](reading::PlacedTask read) {
    return std::move(read.task);
  });
}

}  // namespace cognate::problems
