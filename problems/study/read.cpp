#include "problems/study/read.hpp"

#include <utility>

#include "problems/study/read_tables.hpp"
#include "problems/task_document.hpp"

namespace cognate::problems {

namespace {

using Faults = std::vector<Fault>;
using Folder = std::filesystem::path;

tl::expected<Study, Faults> study_of(const reading::Table& document, const Folder& folder,
                                     const MetricCatalogue& metrics) {
  reading::FaultList faults;
  Study study = reading::read_study(document, folder, metrics, faults);
  if (!faults.empty()) return tl::unexpected(std::move(faults).sorted());
  return study;
}

tl::expected<TaskOrStudy, Faults> task_or_study_of(const reading::Table& document,
                                                   const Folder& folder,
                                                   const MetricCatalogue& metrics) {
  if (reading::is_study(document)) {
    return study_of(document, folder, metrics).map([](Study study) {
      return TaskOrStudy(std::move(study));
    });
  }
  return reading::read_task(document, folder).map([](TaskAt read) {
    return TaskOrStudy(std::move(read.task));
  });
}

}  // namespace

tl::expected<Study, Faults> parse_study(std::string_view text, const Folder& folder,
                                        const MetricCatalogue& metrics) {
  return reading::read_text(text).and_then(
      [&](const reading::Table& document) { return study_of(document, folder, metrics); });
}

tl::expected<Study, Faults> read_study(const std::filesystem::path& file,
                                       const MetricCatalogue& metrics) {
  return reading::read_source(file).and_then([&](const reading::Source& source) {
    return study_of(source.document, source.folder, metrics);
  });
}

tl::expected<TaskOrStudy, Faults> parse_task_or_study(std::string_view text, const Folder& folder,
                                                      const MetricCatalogue& metrics) {
  return reading::read_text(text).and_then(
      [&](const reading::Table& document) { return task_or_study_of(document, folder, metrics); });
}

tl::expected<TaskOrStudy, Faults> read_task_or_study(const std::filesystem::path& file,
                                                     const MetricCatalogue& metrics) {
  return reading::read_source(file).and_then([&](const reading::Source& source) {
    return task_or_study_of(source.document, source.folder, metrics);
  });
}

}  // namespace cognate::problems
