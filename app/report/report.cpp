#include "app/report/report.hpp"

#include <nlohmann/json.hpp>

#include "app/report/analysis_report_data.hpp"
#include "app/report/cam_report_data.hpp"
#include "app/report/filled_page.hpp"
#include "app/report/gear_report_data.hpp"
#include "app/report/machine_report_data.hpp"
#include "app/report/page.hpp"
#include "app/report/report_data.hpp"

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

std::string report_html(const ordered_json& result_document, const problems::Problem& problem,
                        const problems::Result& result) {
  ordered_json data = report_data(problem, result);
  data["result"] = without_large_tables(result_document);
  return filled_page(design_page(), data);
}

std::string report_html(const ordered_json& result_document,
                        const problems::AnalysisProblem& problem,
                        const problems::AnalysisResult& result) {
  ordered_json data = analysis_report_data(problem, result);
  data["result"] = without_large_tables(result_document);
  const bool editable = problem.mechanism.type != problems::MechanismType::chain;
  return filled_page(editable ? analysis_page() : without_kernel(analysis_page()), data);
}

std::string report_html(const ordered_json& result_document,
                        const problems::MachineProblem& problem,
                        const problems::MachineResult& result) {
  ordered_json data = machine_report_data(problem, result);
  data["result"] = without_large_tables(result_document);
  data["thinned"] = are_motions_large(result_document);
  return filled_page(machine_page(), data);
}

std::string report_html(const ordered_json& result_document, const problems::CamProblem& problem,
                        const problems::CamResult& result) {
  ordered_json data = cam_report_data(problem, result);
  data["result"] = without_large_tables(result_document);
  return filled_page(cam_page(), data);
}

std::string report_html(const ordered_json& result_document, const problems::GearProblem& problem,
                        const problems::GearResult& result) {
  ordered_json data = gear_report_data(problem, result);
  data["result"] = without_large_tables(result_document);
  return filled_page(gear_page(), data);
}

std::string report_html(const ordered_json& result_document,
                        const problems::GearPairProblem& problem,
                        const problems::GearPairResult& result) {
  ordered_json data = gear_pair_report_data(problem, result);
  data["result"] = without_large_tables(result_document);
  return filled_page(gear_page(), data);
}

}  // namespace cognate::app
