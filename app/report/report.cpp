#include "app/report/report.hpp"

#include <nlohmann/json.hpp>

#include "app/report/filled_page.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

bool are_motions_large(const ordered_json& document) {
  return document.contains("machine") && is_large(document["machine"], "motions");
}

/// `document` without what would make the page too large: the table of an analysis, and with it the
/// positions of its drive; the tables of a machine; the curves of a synthesis; the motion of a cam.
ordered_json without_large_tables(const ordered_json& document) {
  ordered_json kept = document;
  if (kept.contains("analysis") && is_large(kept["analysis"], "columns")) {
    kept["analysis"].erase("columns");
    for (auto& design : kept["designs"]) {
      for (const char* positions : {"crank_deg", "slide"}) design.erase(positions);
    }
  }
  if (are_motions_large(document)) {
    for (auto& motion : kept["machine"]["motions"]) motion.erase("columns");
  }
  erase_large(kept, "loci");
  for (const char* member : {"motion", "segments", "jumps"}) erase_large(kept, member);
  if (kept.contains("problem")) erase_large(kept["problem"], "motion");
  if (kept.contains("designs")) {
    for (auto& design : kept["designs"]) {
      if (design.contains("mechanism")) erase_large(design["mechanism"], "motion");
    }
  }
  return kept;
}

}  // namespace

std::string report_page(std::string page, ordered_json data, const ordered_json& result_document) {
  data["result"] = without_large_tables(result_document);
  if (result_document.contains("machine")) data["thinned"] = are_motions_large(result_document);
  const auto problem = result_document.value("problem", ordered_json::object());
  return filled_page(std::move(page), data, problem.value("length_unit", std::string()));
}

}  // namespace cognate::app
