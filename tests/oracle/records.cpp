#include "tests/oracle/records.hpp"

#include <toml++/toml.h>

#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "analysis/numbers/constants.hpp"
#include "problems/read.hpp"
#include "tests/support/folders.hpp"

namespace cognate {
namespace {

const std::filesystem::path library = kLibraryFolder;

PublishedError published_error(const toml::table& entry) {
  PublishedError published;
  published.method = entry.at("method").value<std::string>().value();
  published.error = entry.at("error").value<double>().value();
  published.evaluations = entry["evaluations"].value<long>();
  return published;
}

/// Lays `changes` over `table`, key by key.
void change(toml::table& table, const toml::table& changes) {
  for (const auto& [key, value] : changes) {
    if (value.is_table() && table[key].is_table()) {
      change(*table[key].as_table(), *value.as_table());
    } else {
      table.insert_or_assign(key, value);
    }
  }
}

RecordedProblem read_changed(const std::string& file, const toml::table* changes) {
  toml::table table = toml::parse_file((library / file).string());
  if (changes) change(table, *changes);
  std::ostringstream text;
  text << table;
  const auto task = problems::parse_task(text.str());
  if (!task) throw std::runtime_error(file + ": " + task.error().front().message);
  return std::visit(
      [&]<class Problem>(const Problem& problem) -> RecordedProblem {
        if constexpr (std::is_constructible_v<RecordedProblem, Problem>) return problem;
        throw std::runtime_error(file + ": no problem of a kind that records are of");
      },
      *task);
}

double squared_size(const problems::PathProblem& problem) {
  Vec2d centre{};
  const double share = 1.0 / double(problem.points.size());
  for (const Vec2d& p : problem.points) centre = centre + share * p;
  double squares = 0;
  for (const Vec2d& p : problem.points) squares += share * squared_norm(p - centre);
  return squares;
}

}  // namespace

std::vector<Record> read_records() {
  const toml::table file = toml::parse_file(std::string(kOracleFolder) + "/records.toml");
  std::vector<Record> records;
  for (const auto& node : *file["record"].as_array()) {
    const toml::table& entry = *node.as_table();
    Record record;
    const auto problem = entry.at("file").value<std::string>().value();
    record.name = std::filesystem::path(problem).stem().string();
    if (const auto variant = entry["variant"].value<std::string>()) {
      record.name += " (" + *variant + ")";
    }
    record.problem = read_changed(problem, entry["with"].as_table());
    record.source = entry.at("source").value<std::string>().value();
    const auto degrees = entry["best_known_deg"].value<double>();
    record.largest = degrees.has_value();
    record.best_known =
        degrees ? *degrees * kPi / 180 : entry.at("best_known").value<double>().value();
    record.exact = entry["exact"].value_or(false);
    record.infimum = entry["infimum"].value_or(false);
    if (const toml::array* published = entry["published"].as_array()) {
      for (const auto& item : *published) {
        record.published.push_back(published_error(*item.as_table()));
      }
    }
    records.push_back(std::move(record));
  }
  return records;
}

double recorded_error(const Record& record, const problems::Design& design) {
  return record.largest ? design.error.max : design.error.sum_of_squares;
}

bool reaches(const Record& record, double error) {
  if (record.exact) {
    return error <= 1e-20 * squared_size(std::get<problems::PathProblem>(record.problem));
  }
  return error <= record.best_known * (1 + (record.infimum ? 1e-3 : 1e-6));
}

}  // namespace cognate
