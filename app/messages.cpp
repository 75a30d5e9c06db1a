#include "app/messages.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "app/terminal.hpp"

namespace cognate::app {

std::string printable(std::string_view text) {
  std::string safe(text);
  const auto is_control = [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; };
  std::ranges::replace_if(safe, is_control, '?');
  return safe;
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
