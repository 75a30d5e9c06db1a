#include "app/study/atlas_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "app/study/checksum.hpp"
#include "app/study/database.hpp"
#include "app/study/read_columns.hpp"
#include "app/study/read_rows.hpp"
#include "app/study/schema.hpp"
#include "app/study/sqlite.hpp"
#include "problems/read.hpp"
#include "problems/study/four_bar_designs.hpp"
#include "problems/study/key_path.hpp"

namespace cognate::app {
namespace {

using problems::AtlasCurve;

/// The names of the descriptors' columns end in these.
struct Harmonic {
  int number;
  const char* name;
};
constexpr std::array<Harmonic, 8> kDescriptors{
    {{-4, "m4"}, {-3, "m3"}, {-2, "m2"}, {-1, "m1"}, {1, "p1"}, {2, "p2"}, {3, "p3"}, {4, "p4"}}};

bool has_phase(const Harmonic& harmonic) {
  return std::abs(harmonic.number) > 1;
}

/// What is not as it must be, as a sentence.
struct Misfit {
  std::string text;
};

FourBar base_of(SqliteDatabase& database) {
  const auto base = problems::parse_task<problems::AnalysisProblem>(
      database.text("SELECT value FROM study WHERE name = 'base'"));
  const bool traces =
      base && base->mechanism.four_bar() && base->mechanism.four_bar()->coupler_point;
  if (!traces) throw Misfit{"its base is no analysis of a four-bar with a coupler point"};
  return *base->mechanism.four_bar();
}

/// Reads the rows of a study of four-bars.
class AtlasRows {
 public:
  explicit AtlasRows(SqliteDatabase& database)
      : base_(base_of(database)), statement_(database.prepare(query(database))) {}

  std::vector<AtlasCurve> read() {
    std::vector<AtlasCurve> curves;
    while (statement_.step()) {
      if (auto curve = next()) curves.push_back(*std::move(curve));
    }
    return curves;
  }

 private:
  std::string query(SqliteDatabase& database) {
    std::string columns;
    for (const auto& key : stored_names(database, "variables")) {
      const auto path = problems::reading::parse_key_path(key);
      const auto dimension = path ? problems::four_bar_dimension(*path) : std::nullopt;
      if (!dimension) throw Misfit{fmt::format("{} varies, which is no dimension", key)};
      dimensions_.push_back(*dimension);
      columns += sql_name(key) + ", ";
    }
    if (dimensions_.empty()) throw Misfit{"nothing varies in it"};
    const auto metrics = stored_names(database, "metrics");
    const auto add = [&](const std::string& name) {
      if (std::ranges::find(metrics, name) == metrics.end()) {
        throw Misfit{fmt::format("it has no column {}", name)};
      }
      columns += sql_name(name) + ", ";
    };
    for (const auto& harmonic : kDescriptors) {
      add(fmt::format("fourier.{}", harmonic.name));
      if (has_phase(harmonic)) add(fmt::format("fourier_phase_deg.{}", harmonic.name));
    }
    return "SELECT " + columns + "id FROM runs WHERE status = 'solved' ORDER BY id";
  }

  /// The row that the statement is at; empty where it has no numbers, or the crank does not turn.
  std::optional<AtlasCurve> next() {
    int column = 0;
    std::vector<double> values;
    for (std::size_t i = 0; i < dimensions_.size(); ++i) values.push_back(number(column++));
    designs_.fill(base_, dimensions_, values);
    AtlasCurve curve{designs_.design(base_, 0), {}};
    for (const auto& harmonic : kDescriptors) {
      const double magnitude = number(column++);
      const double phase = has_phase(harmonic) ? number(column++) * kPi / 180 : 0;
      curve.descriptors.of(harmonic.number) = {magnitude * std::cos(phase),
                                               magnitude * std::sin(phase)};
    }
    const auto links = lengths(curve.linkage);
    const bool is_linkage = links.crank > 0 && links.coupler > 0 && links.rocker > 0 &&
                            links.frame > 0 && std::isfinite(links.frame);
    return is_linkage && crank_rotates(links) ? std::optional(curve) : std::nullopt;
  }

  /// 0 where there is no number, as of a phase that a curve does not have.
  double number(int column) const {
    const auto cell = statement_.cell(column);
    const auto* const value = std::get_if<double>(&cell);
    return value && std::isfinite(*value) ? *value : 0;
  }

  FourBar base_;
  std::vector<DesignVariable> dimensions_;
  SqliteStatement statement_;
  problems::FourBarDesigns designs_;
};

}  // namespace

tl::expected<std::vector<problems::AtlasCurve>, std::vector<problems::Fault>> problem_atlas(
    const problems::PathProblem& problem) {
  if (!problem.atlas) return {};
  const auto& atlas = *problem.atlas;
  return read_atlas(atlas.file).map_error([&](const std::string& why) {
    return std::vector{problems::Fault{atlas.line, atlas.column,
                                       fmt::format("solve.atlas is \"{}\": {}", atlas.name, why)}};
  });
}

tl::expected<std::vector<AtlasCurve>, std::string> read_atlas(const std::filesystem::path& file) {
  const auto refused = [](const std::string& why) {
    return tl::unexpected(why +
                          "; an atlas is a study of a four-bar's dimensions with all metrics "
                          "fourier.* and fourier_phase_deg.*");
  };
  try {
    auto database = study_rows(file);
    if (database.integer("PRAGMA application_id") != kStudyApplicationId) {
      return refused("it is no study file");
    }
    check_rows(database);
    auto curves = AtlasRows(database).read();
    if (curves.empty()) return refused("it has no curve of a crank that turns fully");
    return curves;
  } catch (const Misfit& misfit) {
    return refused(misfit.text);
  } catch (const StudyFileError& error) {
    return refused(error.what());
  } catch (const SqliteError& error) {
    return refused(fmt::format("it cannot be read: {}", error.what()));
  } catch (const nlohmann::json::exception&) {
    return refused("it is damaged: it has no names of its columns");
  }
}

}  // namespace cognate::app
