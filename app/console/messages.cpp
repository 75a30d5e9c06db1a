#include "app/console/messages.hpp"

#include <fmt/core.h>

#include "app/console/terminal.hpp"

namespace cognate::app {

std::string printable(std::string_view text) {
  std::string safe;
  safe.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
    // U+0080 to U+009F, of which terminals take U+009B for ESC [.
    const bool high_control = byte == 0xc2 && next >= 0x80 && next < 0xa0;
    if (high_control) ++i;
    safe += high_control || byte < ' ' || byte == 0x7f ? '?' : text[i];
  }
  return safe;
}

std::string titled(const std::string& title, const std::string& what) {
  return printable(title.empty() ? what : title + ": " + what);
}

std::string fault_lines(const std::filesystem::path& file,
                        const std::vector<problems::Fault>& faults) {
  std::string lines;
  for (const auto& fault : faults) {
    lines += printable(
        fmt::format("{}:{}:{}: {}", file.string(), fault.line, fault.column, fault.message));
    lines += '\n';
  }
  return lines;
}

void complain(std::string_view message) {
  write_standard_error(fmt::format("cognate: {}\n", printable(message)));
}

ExitStatus print(std::string_view text) {
  const auto error = write_standard_output(text);
  if (!error) return exit_done;
  complain("cannot write to standard output: " + error.message());
  return exit_bad_input;
}

}  // namespace cognate::app
