#include "tests/oracle/records.hpp"

#include <toml++/toml.h>

namespace cognate {
namespace {

const std::filesystem::path library = COGNATE_LIBRARY_DIR;

PublishedError published_error(const toml::table& entry) {
  PublishedError published;
  published.method = entry.at("method").value<std::string>().value();
  published.error = entry.at("error").value<double>().value();
  published.evaluations = entry["evaluations"].value<long>();
  return published;
}

}  // namespace

std::vector<Record> read_records() {
  const toml::table file = toml::parse_file(COGNATE_RECORDS_FILE);
  std::vector<Record> records;
  for (const auto& node : *file["record"].as_array()) {
    const toml::table& entry = *node.as_table();
    Record record;
    record.file = library / entry.at("file").value<std::string>().value();
    record.source = entry.at("source").value<std::string>().value();
    record.best_known = entry.at("best_known").value<double>().value();
    record.exact = entry["exact"].value_or(false);
    for (const auto& item : *entry["published"].as_array()) {
      record.published.push_back(published_error(*item.as_table()));
    }
    records.push_back(std::move(record));
  }
  return records;
}

bool reaches(const Record& record, double error, double squared_size) {
  if (record.exact) return error <= 1e-20 * squared_size;
  return error <= record.best_known * (1 + 1e-6);
}

}  // namespace cognate
