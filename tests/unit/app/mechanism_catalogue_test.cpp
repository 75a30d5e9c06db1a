#include "app/documents/mechanism_catalogue.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "problems/basics/names.hpp"
#include "problems/read.hpp"

namespace cognate::app::mechanism_catalogue_test {
namespace {

using Words = std::set<std::string>;

/// What the message about an unknown key of `text` says is allowed.
Words allowed_by_reader(const std::string& text) {
  const auto task = problems::parse_task(text);
  EXPECT_FALSE(task);
  if (task) return {};
  for (const auto& fault : task.error()) {
    const auto allowed = fault.message.find("allowed are ");
    if (!fault.message.starts_with("unknown key") || allowed == std::string::npos) continue;
    Words words;
    for (auto begin = fault.message.find('"', allowed); begin != std::string::npos;) {
      const auto end = fault.message.find('"', begin + 1);
      words.insert(fault.message.substr(begin + 1, end - begin - 1));
      begin = fault.message.find('"', end + 1);
    }
    return words;
  }
  ADD_FAILURE() << "no unknown key";
  return {};
}

Words keys_of(const KeyedEntry& entry, Words names) {
  for (const auto& key : entry.keys) names.emplace(key.name);
  return names;
}

template <class Enum>
std::vector<std::string_view> names_of() {
  std::vector<std::string_view> all;
  for (const auto& named : problems::names<Enum>()) all.push_back(named.name);
  return all;
}

std::vector<std::string_view> names_of(std::span<const KeyedEntry> entries) {
  std::vector<std::string_view> all;
  for (const auto& entry : entries) all.push_back(entry.name);
  return all;
}

constexpr std::string_view kNoKey = "qwertyuiopasdfghjkl = 1\n";

TEST(MechanismCatalogue, NamesEveryTypeAndDyad) {
  EXPECT_EQ(names_of(mechanisms()), names_of<problems::MechanismType>());
  EXPECT_EQ(names_of(dyads()), names_of<problems::DyadType>());
}

TEST(MechanismCatalogue, HasTheKeysThatTheReaderAllows) {
  int tested = 0;
  for (const auto& type : mechanisms()) {
    if (type.name == "chain") continue;
    ++tested;
    const auto text =
        fmt::format("kind = \"analysis\"\n[mechanism]\ntype = \"{}\"\n{}", type.name, kNoKey);
    EXPECT_EQ(allowed_by_reader(text), keys_of(type, {"type", "point", "link", "load", "gravity"}))
        << type.name;
  }
  EXPECT_GE(tested, 9);
}

TEST(MechanismCatalogue, HasTheKeysOfDyadsThatTheReaderAllows) {
  for (const auto& dyad : dyads()) {
    const auto text = fmt::format(
        "kind = \"analysis\"\nmechanism.type = \"chain\"\n[[dyad]]\ntype = \"{}\"\nlength = 1\n{}",
        dyad.name, kNoKey);
    Words allowed = allowed_by_reader(text);
    EXPECT_EQ(allowed, keys_of(dyad, {"type", "names"})) << dyad.name;
  }
}

}  // namespace
}  // namespace cognate::app::mechanism_catalogue_test
