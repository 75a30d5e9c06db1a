// Reading a mutated file of the library gives a problem or at least one fault.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "problems/read.hpp"
#include "tests/fuzz/sound_analysis.hpp"
#include "tests/fuzz/sound_cam.hpp"
#include "tests/fuzz/sound_machine.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::read_mutations_test {
namespace {

std::vector<std::string> library() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kLibraryFolder)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::ranges::sort(files);  // the order of a directory is not the same everywhere
  std::vector<std::string> texts;
  for (const auto& file : files) {
    std::ifstream stream(file, std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return texts;
}

using Random = std::mt19937;

std::size_t below(std::size_t n, Random& random) {
  return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
}

// One edit of a kind that people, editors and broken disks make.
void mutate(std::string& text, const std::vector<std::string>& others, Random& random) {
  const std::vector<std::string> tokens = {
      "nan", "-inf", "0",  "-1", "1e300", "\"\"", "[]",     "{}",   "true", "[[",
      "]",   "=",    "\n", ".",  "#",     "\"",   "1e-300", "free", "x",    std::string(1, '\0'),
      "'''"};
  const std::size_t at = below(text.size() + 1, random);
  const std::size_t length = std::min(text.size() - at, below(20, random));
  switch (below(6, random)) {
    case 0:
      text.erase(at, length);
      break;
    case 1:
      text.insert(at, tokens[below(tokens.size(), random)]);
      break;
    case 2:
      text.replace(at, length, tokens[below(tokens.size(), random)]);
      break;
    case 3:
      if (at < text.size()) text[at] = static_cast<char>(below(256, random));
      break;
    case 4:
      text.insert(below(text.size() + 1, random), text.substr(at, length));
      break;
    default: {
      const std::string& other = others[below(others.size(), random)];
      text.insert(at, other.substr(below(other.size(), random), 40));
    }
  }
}

void check(const std::string& text) {
  const auto task = parse_task(text);
  if (task) {
    const auto* analysis = std::get_if<AnalysisProblem>(&*task);
    ASSERT_TRUE(analysis == nullptr || is_sound(*analysis)) << text;
    const auto* cam = std::get_if<CamProblem>(&*task);
    ASSERT_TRUE(cam == nullptr || is_sound(*cam)) << text;
    const auto* machine = std::get_if<MachineProblem>(&*task);
    ASSERT_TRUE(machine == nullptr || is_sound(*machine)) << text;
    return;
  }
  ASSERT_FALSE(task.error().empty()) << text;
  ASSERT_LE(task.error().size(), 100U) << text;
  const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
  std::size_t last_line = 1;
  for (const Fault& fault : task.error()) {
    ASSERT_GE(fault.line, last_line) << "out of order in\n" << text;
    ASSERT_LE(fault.line, lines) << text;
    ASSERT_GE(fault.column, 1U) << text;
    ASSERT_NE(fault.message.find("; "), std::string::npos) << fault.message << "\n" << text;
    last_line = fault.line;
  }
}

TEST(ReadMutationsTest, EveryTextGivesAProblemOrFaults) {
  const std::vector<std::string> texts = library();
  ASSERT_FALSE(texts.empty());
  Random random(20260101);
  for (int trial = 0; trial < 20'000; ++trial) {
    std::string text = texts[below(texts.size(), random)];
    for (std::size_t edits = 1 + below(4, random); edits > 0; --edits) mutate(text, texts, random);
    ASSERT_NO_THROW(check(text)) << text;
    if (HasFatalFailure()) return;
  }
}

TEST(ReadMutationsTest, EveryPrefixGivesAProblemOrFaults) {
  for (const std::string& text : library()) {
    for (std::size_t length = 0; length <= text.size(); ++length) {
      ASSERT_NO_THROW(check(text.substr(0, length)));
      if (HasFatalFailure()) return;
    }
  }
}

}  // namespace
}  // namespace cognate::problems::read_mutations_test
