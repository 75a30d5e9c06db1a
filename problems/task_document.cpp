#include "problems/task_document.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "problems/toml/file_text.hpp"
#include "problems/toml/nearest.hpp"
#include "problems/toml/table_reader.hpp"
#include "problems/toml/text_check.hpp"

namespace cognate::problems::reading {
namespace {

using Faults = std::vector<Fault>;
using Folder = std::filesystem::path;

/// Whether a kind has its word from another, beside which it takes some of the documents.
template <class Kind>
constexpr bool shares_word = requires(TableReader& document) {
  KindTraits<Kind>::takes(document);
};

template <class... Kind>
constexpr auto words_of(std::type_identity<std::variant<Kind...>>) {
  std::array<std::string_view, (0 + ... + (shares_word<Kind> ? 0 : 1))> words;
  auto next = words.begin();
  ((shares_word<Kind> ? void() : void(*next++ = KindTraits<Kind>::kWord)), ...);
  return words;
}

constexpr auto kTaskKinds = words_of(std::type_identity<Task>{});

constexpr std::string_view kBase = "base";

tl::unexpected<Faults> refusal(std::string message) {
  return tl::unexpected(Faults{{1, 1, std::move(message)}});
}

bool is_blank(std::string_view text) {
  return std::ranges::all_of(
      text, [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; });
}

// A study has many tasks and is none itself.
void fault_study(TableReader& document) {
  const std::string_view place = document.has(kKind) ? kKind : kBase;
  document.fault(place, fmt::format("{}, which 'cognate sweep' runs; expected one of {} here",
                                    place == kKind ? "is \"study\"" : "makes this a study",
                                    quoted_list(kTaskKinds)));
}

// The document's kind, one of kTaskKinds; empty, with a fault, where it has none.
std::optional<std::string_view> read_kind(TableReader& document) {
  if (!document.has(kKind)) {
    document.fault(kKind, fmt::format("is missing; allowed are {}", quoted_list(kTaskKinds)));
    return std::nullopt;
  }
  const auto kind = document.text(kKind);
  if (!kind) return std::nullopt;
  const auto found = std::ranges::find(kTaskKinds, *kind);
  if (found != kTaskKinds.end()) return *found;
  std::vector<std::string_view> known(kTaskKinds.begin(), kTaskKinds.end());
  known.push_back(kStudyKind);
  const auto meant = nearest(*kind, known);
  document.fault(
      kKind, fmt::format("is {}{}; available are {}", in_quotes(*kind),
                         meant ? ", perhaps for " + in_quotes(*meant) : "", quoted_list(known)));
  return std::nullopt;
}

// The problem of kind `word`, one of kTaskKinds.
Task read_of_kind(std::string_view word, TableReader& document, const Folder& folder) {
  Task (*read)(TableReader&, const Folder&) = nullptr;
  for_each_kind([&]<class Kind>(std::type_identity<Kind>) {
    if (KindTraits<Kind>::kWord != word) return;
    if constexpr (shares_word<Kind>) {
      if (!KindTraits<Kind>::takes(document)) return;
    }
    read = [](TableReader& whole, const Folder& files) {
      return Task(KindTraits<Kind>::read(whole, files));
    };
  });
  return read(document, folder);
}

std::optional<TaskAt> read_document(TableReader& document, const Folder& folder) {
  const auto kind = read_kind(document);
  const std::string title = document.text("title").value_or("");
  const auto length_unit = document.choice<LengthUnit>(kLengthUnit);
  if (!kind) return std::nullopt;
  const Where where = document.where(kKind);
  TaskAt read{read_of_kind(*kind, document, folder), where.line, where.column};
  const auto set_head = [&](auto& problem) {
    problem.title = title;
    problem.length_unit = length_unit;
  };
  std::visit(set_head, read.task);
  document.finish();
  return read;
}

}  // namespace

tl::expected<Table, Faults> read_text(std::string_view text) {
  if (text.size() > kMostBytes) {
    return refusal(fmt::format("the text has {} bytes; at most 8 MiB are allowed", text.size()));
  }
  if (const auto fault = check_is_text(text)) return tl::unexpected(Faults{*fault});
  if (is_blank(text)) {
    return refusal(fmt::format("the file is empty; a problem begins with kind = one of {}",
                               quoted_list(kTaskKinds)));
  }
  if (const auto fault = check_key_depth(text)) return tl::unexpected(Faults{*fault});
  auto table = parse_document(text);
  if (!table) return tl::unexpected(Faults{table.error()});
  return *std::move(table);
}

tl::expected<Source, Faults> read_source(const std::filesystem::path& file) {
  std::error_code error;
  auto folder = std::filesystem::absolute(file, error).parent_path();
  const auto text = text_of(file);
  if (!text) return refusal(text.error());
  return read_text(*text).map([&](Table document) {
    return Source{std::move(document), std::move(folder)};
  });
}

tl::expected<TaskAt, Faults> read_task(const Table& document, const Folder& folder) {
  FaultList faults;
  TableReader reader(document, faults);
  if (is_study(document)) {
    fault_study(reader);
    return tl::unexpected(std::move(faults).sorted());
  }
  auto read = read_document(reader, folder);
  if (!faults.empty() || !read) return tl::unexpected(std::move(faults).sorted());
  return *std::move(read);
}

tl::expected<Table, Faults> with_length_unit(Table document,
                                             std::optional<LengthUnit> length_unit) {
  if (!length_unit) return document;
  const std::string word(to_string(*length_unit));
  const auto given = std::ranges::find(document, kLengthUnit, &Entry::key);
  if (given == document.end()) {
    document.push_back({std::string(kLengthUnit), {}, {.where = {}, .value = word}});
    return document;
  }
  const auto* const own = std::get_if<std::string>(&given->node.value);
  if (!own || *own == word) return document;
  const Where where = given->node.where;
  return tl::unexpected(Faults{
      {where.line, where.column,
       fmt::format("length_unit is {}, but --length-unit says {}; remove one of them, or let "
                   "both say the same",
                   in_quotes(*own), in_quotes(word))}});
}

bool is_study(const Table& document) {
  const auto kind = std::ranges::find(document, kKind, &Entry::key);
  if (kind == document.end())
    return std::ranges::find(document, kBase, &Entry::key) != document.end();
  const auto* word = std::get_if<std::string>(&kind->node.value);
  return word && *word == kStudyKind;
}

}  // namespace cognate::problems::reading
