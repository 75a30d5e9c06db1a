#include "app/console/screen.hpp"

#include <locale.h>
#include <wchar.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <vector>

namespace cognate::app {
namespace {

/// The widths of characters are the C library's, which needs a locale of UTF-8 for them, in any
/// locale of the user.
class Utf8 {
 public:
  Utf8() : locale_(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {}
  Utf8(const Utf8&) = delete;
  Utf8& operator=(const Utf8&) = delete;
  ~Utf8() {
    if (locale_ != nullptr) freelocale(locale_);
  }

  /// The columns of what is no escape. Bytes that are no UTF-8 take one each.
  std::size_t width(const std::string& text) const {
    const locale_t before = locale_ != nullptr ? uselocale(locale_) : nullptr;
    std::size_t columns = 0;
    mbstate_t state{};
    for (std::size_t at = 0; at < text.size();) {
      wchar_t character = 0;
      const std::size_t bytes = mbrtowc(&character, text.data() + at, text.size() - at, &state);
      const bool sound = bytes != 0 && bytes <= text.size() - at;
      const int width = sound ? wcwidth(character) : 1;
      columns += width >= 0 ? static_cast<std::size_t>(width) : 1;
      at += sound ? bytes : 1;
      if (!sound) state = {};
    }
    if (before != nullptr) uselocale(before);
    return columns;
  }

 private:
  locale_t locale_;
};

std::string without_escapes(const std::string& text) {
  std::string seen;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text.compare(at, 2, "\x1b[") == 0) {
      at = std::min(text.find('m', at), text.size());
    } else {
      seen += text[at];
    }
  }
  return seen;
}

/// How far what is broken off a line is set in: to the last column of a list, as long as that
/// leaves it half the width.
std::size_t hanging(const std::string& line, std::size_t width) {
  constexpr std::size_t kUsual = 2;
  constexpr std::string_view kNote = "note: ";
  if (line.starts_with(kNote)) return kNote.size();
  const std::size_t text = std::min(line.find_first_not_of(' '), line.size());
  std::size_t hang = text + kUsual;
  for (auto gap = line.find("  ", text); gap < width / 2; gap = line.find("  ", gap)) {
    gap = std::min(line.find_first_not_of(' ', gap), line.size());
    if (gap <= width / 2) hang = gap;
  }
  return hang;
}

/// The pieces of `line` that end with the space between two words, the last with its end.
std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::size_t begin = 0;
  while (begin < line.size()) {
    const auto text = line.find_first_not_of(' ', begin);
    const auto space = text == std::string::npos ? text : line.find(' ', text);
    words.push_back(line.substr(begin, space == std::string::npos ? space : space + 1 - begin));
    begin = space == std::string::npos ? line.size() : space + 1;
  }
  return words;
}

std::string without_end_spaces(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

std::string broken(const std::string& line, std::size_t width) {
  const std::string indent(hanging(line, width), ' ');
  std::string text;
  std::string current;
  bool begun = false;
  for (const auto& word : words_of(line)) {
    if (begun && display_width(without_end_spaces(current + word)) > width) {
      text += without_end_spaces(current) + '\n';
      current = indent + word.substr(std::min(word.find_first_not_of(' '), word.size()));
    } else {
      current += word;
    }
    begun = true;
  }
  return text + without_end_spaces(current);
}

}  // namespace

std::size_t display_width(const std::string& text) {
  static const Utf8 utf8;
  return utf8.width(without_escapes(text));
}

std::string fitted(const std::string& text, const Screen& screen) {
  if (screen.width == Screen::kUnlimited) return text;
  std::istringstream lines(text);
  std::string all;
  for (std::string line; std::getline(lines, line);) {
    all += (display_width(line) > screen.width ? broken(line, screen.width) : line) + '\n';
  }
  return all;
}

}  // namespace cognate::app
