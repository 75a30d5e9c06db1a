#include "app/report/study_report.hpp"

#include <nlohmann/json.hpp>

#include "app/report/filled_page.hpp"
#include "app/report/page.hpp"
#include "app/report/study_report_data.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

/// `document` without what would make the page too large: the best rows, which are among those
/// drawn, and long lists of values.
ordered_json without_large_lists(const ordered_json& document) {
  ordered_json kept = document;
  for (const char* member : {"best", "study", "notes"}) erase_large(kept, member);
  return kept;
}

}  // namespace

std::string study_report_html(const ordered_json& document, const problems::Study& study,
                              const StudyRows& rows) {
  ordered_json data = study_report_data(study, rows);
  data["result"] = without_large_lists(document);
  return filled_page(study_page(), data);
}

}  // namespace cognate::app
