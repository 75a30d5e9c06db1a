#include "app/shell/manual_page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <sstream>

namespace cognate::app {
namespace {

/// The code point that begins at `at` of UTF-8 `text`; moves `at` behind it.
std::uint32_t next_code_point(std::string_view text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(at++);
  if (first < 0x80) return first;
  std::uint32_t point = first < 0xe0 ? first & 0x1f : first < 0xf0 ? first & 0x0f : first & 0x07;
  while (at < text.size() && (byte(at) >> 6) == 2) point = point << 6 | (byte(at++) & 0x3f);
  return point;
}

/// `text` as roff prints it: hyphens that can be copied, nothing taken for a request.
std::string roff(std::string_view text) {
  std::string safe;
  for (std::size_t at = 0; at < text.size();) {
    const auto point = next_code_point(text, at);
    if (point >= 0x80) {
      safe += fmt::format("\\[u{:04X}]", point);
    } else if (point == '\\') {
      safe += "\\e";
    } else if (point == '-') {
      safe += "\\-";
    } else if (point == '\'') {
      safe += "\\(aq";
    } else if (point == '.' && safe.empty()) {
      safe += "\\&.";
    } else {
      safe += static_cast<char>(point);
    }
  }
  return safe;
}

/// One line of a help text, taken apart.
struct HelpLine {
  std::string_view text;  ///< without its indentation
  std::size_t indent = 0;
  std::string_view term;  ///< of "term   what it means"; else empty
  std::string_view meaning;
};

HelpLine taken_apart(std::string_view line) {
  HelpLine parts;
  parts.indent = std::min(line.find_first_not_of(' '), line.size());
  parts.text = line.substr(parts.indent);
  const auto gap = parts.text.find("  ");
  if (gap != std::string_view::npos) {
    parts.term = parts.text.substr(0, gap);
    parts.meaning = parts.text.substr(parts.text.find_first_not_of(' ', gap));
  }
  return parts;
}

/// A help text as roff: headings, commands as they are typed, terms with their meanings, and prose.
class HelpPage {
 public:
  std::string of(const std::string& help) {
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) add(line);
    end_example();
    return text_;
  }

 private:
  void add(const std::string& line) {
    const HelpLine parts = taken_apart(line);
    if (parts.text.empty()) {
      end_example();
      text_ += fresh_ ? "" : ".PP\n";
      fresh_ = true;
      return;
    }
    if (parts.indent == 0 && parts.text.back() == ':') return add_heading(parts.text);
    if (example_) {
      text_ += roff(parts.text) + '\n';
    } else if (!parts.term.empty()) {
      text_ += fmt::format(".TP\n.B {}\n{}\n", roff(parts.term), roff(parts.meaning));
      in_term_ = true;
    } else {
      if (in_term_ && parts.indent <= kProse) text_ += ".PP\n";
      in_term_ = in_term_ && parts.indent > kProse;
      text_ += roff(parts.text) + '\n';
    }
    fresh_ = false;
  }

  void add_heading(std::string_view heading) {
    end_example();
    text_ += fmt::format("{}.B {}\n", fresh_ ? "" : ".PP\n", roff(heading));
    example_ = heading.starts_with("Example");
    text_ += example_ ? ".PP\n.RS 4\n.nf\n" : ".PP\n";
    fresh_ = true;
    in_term_ = false;
  }

  void end_example() {
    if (example_) text_ += ".fi\n.RE\n";
    example_ = false;
  }

  static constexpr std::size_t kProse = 2;  // columns by which prose is set in

  std::string text_;
  bool example_ = false;
  bool in_term_ = false;
  bool fresh_ = true;  ///< whether a paragraph has begun and holds nothing yet
};

std::string option_text(const OptionWords& option) {
  std::string names;
  for (const auto& name : option.names) {
    names += (names.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
  }
  if (!option.argument.empty()) names += " \\fI" + roff(option.argument) + "\\fR";
  return fmt::format(".TP\n{}\n{}\n", names, roff(option.meaning));
}

bool has_option(const CommandWords& command, const OptionWords& option) {
  return std::ranges::any_of(command.options,
                             [&](const OptionWords& other) { return other.names == option.names; });
}

/// The options of the program: those that its commands take too, then those without a command.
std::string common_options(const CommandTree& tree) {
  std::string taken, alone;
  for (const auto& option : tree.program.options) {
    const bool by_all = std::ranges::all_of(
        tree.commands, [&](const CommandWords& command) { return has_option(command, option); });
    (by_all ? taken : alone) += option_text(option);
  }
  return "Every command takes these.\n" + taken + ".PP\nWithout a command:\n" + alone;
}

std::string command_text(const CommandWords& command, const CommandWords& program) {
  auto text =
      fmt::format(".SS cognate {}{}\n{}\n", roff(command.name),
                  command.argument.empty() ? "" : " " + command.argument, roff(command.purpose));
  if (!command.argument.empty()) {
    text += fmt::format(".TP\n.I {}\n{}\n", command.argument, roff(command.argument_meaning));
  }
  for (const auto& option : command.options) {
    if (!has_option(program, option)) text += option_text(option);
  }
  return text + ".PP\n" + HelpPage().of(command.more);
}

}  // namespace

std::string manual_page(const CommandTree& tree, std::string_view version) {
  auto text = fmt::format(
      ".\\\" Made by 'cognate manual'.\n"
      ".TH COGNATE 1 \"\" \"Cognate {}\" \"User Commands\"\n"
      ".SH NAME\ncognate \\- synthesis and analysis of planar linkages and cams\n"
      ".SH SYNOPSIS\n.B cognate\n.I COMMAND\n[\\fIOPTIONS\\fR] [\\fIFILE\\fR]\n"
      ".SH DESCRIPTION\n{}.SH OPTIONS\n",
      version, HelpPage().of(tree.program.purpose));
  text += common_options(tree);
  text += ".SH COMMANDS\n";
  for (const auto& command : tree.commands) text += command_text(command, tree.program);
  return text + ".SH MORE\n" + HelpPage().of(tree.program.more);
}

}  // namespace cognate::app
