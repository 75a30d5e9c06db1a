#include "app/report/kernel/answer.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "app/report/kernel/numbers.hpp"

namespace cognate::page {
namespace {
std::string text;
}  // namespace

std::string_view question() {
  return text;
}

int answer_with(const nlohmann::ordered_json& answer) {
  text = answer.dump();
  return static_cast<int>(text.size());
}

nlohmann::ordered_json faults_json(problems::reading::FaultList faults) {
  auto sentences = nlohmann::ordered_json::array();
  for (const auto& fault : std::move(faults).sorted()) sentences.push_back(fault.message);
  return {{"faults", std::move(sentences)}};
}

/// Makes room for a text of `size` bytes, which the page puts there.
COGNATE_EXPORT(room) char* make_room(int size) {
  text.assign(static_cast<std::size_t>(std::max(size, 0)), ' ');
  return text.data();
}

/// Where the text of the last call begins.
COGNATE_EXPORT(text) const char* text_begin() {
  return text.data();
}

}  // namespace cognate::page
