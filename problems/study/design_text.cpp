#include "problems/study/design_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

#include "problems/study/base.hpp"
#include "problems/study/key_path.hpp"
#include "problems/task_document.hpp"

namespace cognate::problems {
namespace {

using reading::Where;

/// A number of the base that varies: where it stands, and of which variable it is.
struct Place {
  Where where;
  std::size_t variable = 0;
  bool integer = false;
};

std::vector<Place> places_of(const Study& study) {
  std::vector<Place> places;
  auto table = reading::read_text(study.base_text);
  for (std::size_t i = 0; table && i < study.variables.size(); ++i) {
    const auto* node = reading::find_node(*table, study.variables[i].path);
    if (!node) continue;
    places.push_back({node->where, i, std::holds_alternative<std::int64_t>(node->value)});
  }
  std::ranges::sort(places, {}, &Place::where);
  return places;
}

/// Goes through a text by lines and columns, in characters.
class Cursor {
 public:
  explicit Cursor(const std::string& text) : text_(text) {
    if (text_.starts_with("\xef\xbb\xbf")) offset_ = 3;  // a byte order mark has no column
  }

  /// The byte at `where`, which is not before the last one requested.
  std::size_t offset(Where where) {
    while (offset_ < text_.size() && at_ < where) {
      const bool line_ends = text_[offset_] == '\n';
      at_ = line_ends ? Where{at_.line + 1, 1} : Where{at_.line, at_.column + 1};
      ++offset_;
      while (offset_ < text_.size() &&
             (static_cast<unsigned char>(text_[offset_]) & 0xc0U) == 0x80U)
        ++offset_;
    }
    return offset_;
  }

 private:
  const std::string& text_;
  Where at_;
  std::size_t offset_ = 0;
};

/// One past the string that begins at `begin`, with one quotation mark or three.
std::size_t end_of_string(const std::string& text, std::size_t begin) {
  const std::string three(3, text[begin]);
  const std::string mark = text.compare(begin, 3, three) == 0 ? three : three.substr(0, 1);
  for (std::size_t at = begin + mark.size(); at < text.size(); ++at) {
    if (text.compare(at, mark.size(), mark) == 0) return at + mark.size();
    if (text[at] == '\\' && mark.front() == '"') ++at;
  }
  return text.size();
}

/// One past the number that begins at `begin`, which may be an expression in a string.
std::size_t end_of_number(const std::string& text, std::size_t begin) {
  const bool quoted = begin < text.size() && (text[begin] == '"' || text[begin] == '\'');
  if (quoted) return end_of_string(text, begin);
  const auto belongs = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '+' ||
           c == '-' || c == '.' || c == '_';
  };
  std::size_t end = begin;
  while (end < text.size() && belongs(text[end])) ++end;
  return end;
}

GappedText gapped(const Study& study, const std::vector<Place>& places) {
  GappedText gaps;
  Cursor cursor(study.base_text);
  std::size_t from = 0;
  for (const Place& place : places) {
    const std::size_t begin = cursor.offset(place.where);
    gaps.pieces.push_back(study.base_text.substr(from, begin - from));
    gaps.variable.push_back(place.variable);
    from = end_of_number(study.base_text, begin);
  }
  gaps.pieces.push_back(study.base_text.substr(from));
  return gaps;
}

/// The shortest text that reads back as `value`, with a sign that it is no integer unless it is.
std::string number_text(double value, bool integer) {
  std::string text = fmt::format("{}", value);
  if (integer && is_whole(value)) return fmt::format("{}", static_cast<std::int64_t>(value));
  const bool fraction = text.find_first_of(".en") != std::string::npos;
  return fraction ? text : text + ".0";
}

}  // namespace

GappedText gapped_base(const Study& study) {
  return gapped(study, places_of(study));
}

std::string design_text(const Study& study, std::span<const double> values) {
  const std::vector<Place> places = places_of(study);
  const GappedText gaps = gapped(study, places);
  std::string text = gaps.pieces.front();
  for (std::size_t i = 0; i < places.size(); ++i) {
    text += number_text(values[places[i].variable], places[i].integer);
    text += gaps.pieces[i + 1];
  }
  return text;
}

}  // namespace cognate::problems
