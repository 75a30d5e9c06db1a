#include "app/studio/taking.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "app/commands/export_design.hpp"
#include "app/export/export_options.hpp"
#include "app/export/exported.hpp"
#include "app/export/result_document.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

/// What messages call the result.
constexpr const char* kResult = "the result";

/// For which a page waits at most, in seconds.
constexpr double kLongestExport = 60;

/// "hole" of "--hole".
std::string_view key_of(std::string_view option) {
  return option.substr(2);
}

template <class Options>
ordered_json names_of(const Options& declared) {
  auto names = ordered_json::array();
  for (const auto& option : declared) names.push_back(key_of(option.name));
  return names;
}

/// The option called `key` among those declared; null where there is none.
template <class Options>
auto option_of(const Options& declared, const std::string& key) {
  const auto found =
      std::ranges::find(declared, key, [](const auto& option) { return key_of(option.name); });
  return found == declared.end() ? nullptr : &*found;
}

/// Sets what `key` is an option of, or says why not.
std::string set_option(ExportTexts& texts, const std::string& key, const ordered_json& value) {
  if (const auto* flag = option_of(kExportFlags, key)) {
    if (!value.is_boolean()) return key + ": expected true or false";
    texts.*(flag->member) = value.get<bool>();
    return {};
  }
  const auto* option = option_of(kExportTexts, key);
  if (!option) return key + ": is no option of an export; remove it";
  if (!value.is_string() && !value.is_number()) return key + ": expected a text or a number";
  texts.*(option->member) = value.is_string() ? value.get<std::string>() : value.dump();
  return {};
}

tl::expected<ExportOptions, std::vector<std::string>> options_in(const ordered_json& asked) {
  ExportTexts texts;
  std::vector<std::string> faults;
  for (const auto& [key, value] : asked.items()) {
    if (auto fault = set_option(texts, key, value); !fault.empty()) {
      faults.push_back(std::move(fault));
    }
  }
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return export_options(texts);
}

ordered_json faults_json(const std::vector<std::string>& faults) {
  return {{"faults", faults}};
}

}  // namespace

ordered_json taking_choices() {
  auto formats = ordered_json::array();
  for (const FormatDeclaration& format : kExportFormats) formats.push_back(format.word);
  return {{"formats", std::move(formats)},
          {"options", names_of(kExportTexts)},
          {"flags", names_of(kExportFlags)}};
}

ordered_json taken(const ordered_json& result, const ordered_json& asked, const std::string& stem,
                   const Options& options) {
  const auto exporting = options_in(asked);
  if (!exporting) return faults_json(exporting.error());
  const auto design =
      result_design(result, exporting->design, kResult).and_then([&](ResultDesign found) {
        return in_length_unit(std::move(found), options.length_unit);
      });
  if (!design) return faults_json({design.error()});
  Options hurried = options;
  hurried.time_limit = std::min(kLongestExport, options.time_limit.value_or(kLongestExport));
  const auto made = export_design(*design, *exporting, stem, hurried);
  if (!made) return faults_json({made.error().message});
  auto files = ordered_json::array();
  for (const ExportedFile& file : made->files) {
    files.push_back({{"name", file.name}, {"text", file.text}});
  }
  return {{"files", std::move(files)}, {"notes", made->notes}, {"summary", made->summary}};
}

}  // namespace cognate::app
