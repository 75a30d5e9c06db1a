#include "problems/toml/text_check.hpp"

#include <fmt/core.h>

#include <cstddef>
#include <cstdint>

namespace cognate::problems::reading {
namespace {

unsigned byte_at(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
}

bool is_continuation(unsigned byte) {
  return (byte & 0xc0U) == 0x80U;
}

// The length of the UTF-8 sequence at `i`, 0 where there is none: shortest forms only, no
// surrogates, nothing beyond U+10FFFF (Unicode, table 3-7).
std::size_t utf8_length(std::string_view text, std::size_t i) {
  const unsigned lead = byte_at(text, i);
  const unsigned second = byte_at(text, i + 1);
  if (lead < 0x80) return 1;
  if (lead >= 0xc2 && lead <= 0xdf) return is_continuation(second) ? 2 : 0;
  if (lead >= 0xe0 && lead <= 0xef) {
    const unsigned low = lead == 0xe0 ? 0xa0 : 0x80;
    const unsigned high = lead == 0xed ? 0x9f : 0xbf;
    return second >= low && second <= high && is_continuation(byte_at(text, i + 2)) ? 3 : 0;
  }
  if (lead >= 0xf0 && lead <= 0xf4) {
    const unsigned low = lead == 0xf0 ? 0x90 : 0x80;
    const unsigned high = lead == 0xf4 ? 0x8f : 0xbf;
    const bool rest =
        is_continuation(byte_at(text, i + 2)) && is_continuation(byte_at(text, i + 3));
    return second >= low && second <= high && rest ? 4 : 0;
  }
  return 0;
}

bool is_forbidden_control(unsigned byte) {
  return (byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r') || byte == 0x7f;
}

bool is_bare_key(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '+';
}

// The end of the string that begins at `i` with a quotation mark, one past its last mark. A string
// that does not end runs to the end of its line (one mark) or of the text (three).
std::size_t end_of_string(std::string_view text, std::size_t i) {
  const char mark = text[i];
  const std::string_view three = text.substr(i, 3);
  const bool multiline = three.size() == 3 && three[1] == mark && three[2] == mark;
  for (std::size_t j = i + (multiline ? 3 : 1); j < text.size(); ++j) {
    if (mark == '"' && text[j] == '\\') {
      ++j;
    } else if (multiline ? text.substr(j, 3) == three : text[j] == mark || text[j] == '\n') {
      return j + (multiline ? 3 : 1);
    }
  }
  return text.size();
}

Fault fault_at(std::string_view text, std::size_t offset, std::string message) {
  Fault fault{1, 1, std::move(message)};
  for (std::size_t i = 0; i < offset; ++i) {
    if (text[i] == '\n') {
      ++fault.line;
      fault.column = 1;
    } else if (!is_continuation(byte_at(text, i))) {
      ++fault.column;
    }
  }
  return fault;
}

}  // namespace

std::optional<Fault> check_is_text(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const unsigned byte = byte_at(text, i);
    const std::size_t length = utf8_length(text, i);
    if (length == 0 || is_forbidden_control(byte)) {
      return fault_at(
          text, i,
          fmt::format("the file is not text: byte {:#04x} at offset {} is {}; a problem "
                      "file is TOML in UTF-8",
                      byte, i, length == 0 ? "not UTF-8" : "a control character"));
    }
    i += length;
  }
  return std::nullopt;
}

std::optional<Fault> check_key_depth(std::string_view text) {
  constexpr int kDeepest = 16;
  int parts = 0;  // of the dotted sequence that ends here; a number such as 1.5 counts two
  bool after_dot = false;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    const std::size_t begin = i;
    const bool quote = c == '"' || c == '\'';
    if (quote || is_bare_key(c)) {
      if (quote) {
        i = end_of_string(text, i);
      } else {
        while (i < text.size() && is_bare_key(text[i])) ++i;
      }
      parts = after_dot ? parts + 1 : 1;
      after_dot = false;
      if (parts > kDeepest) {
        return fault_at(
            text, begin,
            fmt::format("a key of more than {0} dotted parts; at most {0} are allowed", kDeepest));
      }
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '.') {
      after_dot = true;
    } else if (c != ' ' && c != '\t') {
      after_dot = false;
      parts = 0;
    }
    ++i;
  }
  return std::nullopt;
}

}  // namespace cognate::problems::reading
