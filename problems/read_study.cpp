#include "problems/read_study.hpp"

#include "problems/reading/file_text.hpp"
#include "problems/reading/study_file.hpp"
#include "problems/reading/task_document.hpp"

namespace cognate::problems {

using Faults = std::vector<Fault>;

tl::expected<Study, Faults> parse_study(std::string_view text, const std::filesystem::path& folder,
                                        const MetricCatalogue& metrics) {
  const auto document = reading::read_text(text);
  if (!document) return tl::unexpected(document.error());
  reading::FaultList faults;
  Study study = reading::read_study(*document, folder, metrics, faults);
  if (!faults.empty()) return tl::unexpected(std::move(faults).sorted());
  return study;
}

tl::expected<Study, Faults> read_study(const std::filesystem::path& file,
                                       const MetricCatalogue& metrics) {
  std::error_code error;
  const auto folder = std::filesystem::absolute(file, error).parent_path();
  const auto text = reading::text_of(file);
  if (!text) return tl::unexpected(Faults{{1, 1, text.error()}});
  return parse_study(*text, folder, metrics);
}

bool is_study_file(const std::filesystem::path& file) {
  const auto text = reading::text_of(file);
  if (!text) return false;
  const auto document = reading::read_text(*text);
  return document && reading::is_study(*document);
}

}  // namespace cognate::problems
