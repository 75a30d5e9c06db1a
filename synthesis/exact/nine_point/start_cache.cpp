#include "synthesis/exact/nine_point/start_cache.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include "synthesis/exact/nine_point/number_file.hpp"

namespace cognate::synthesis::nine_point {
namespace {

/// Seeds to try before an incomplete set is taken. The first has always been enough.
constexpr unsigned kSeeds = 4;

FileKey key_of(const PathClass& kind) {
  return {static_cast<std::uint64_t>(kind.poses), static_cast<std::uint64_t>(kind.points), 0};
}

/// Visits the numbers of a set in the order of its file.
template <class Set, class Visit>
void for_each_number(Set& set, const Visit& visit) {
  for (auto* list : {&set.data.d, &set.data.d_bar, &set.data.t}) {
    for (auto& z : *list) {
      double re = z.real(), im = z.imag();
      visit(re);
      visit(im);
      if constexpr (!std::is_const_v<Set>) z = {re, im};
    }
  }
  for (auto& z : set.roots) {
    visit(z.re);
    visit(z.im);
  }
}

/// A set of the right sizes, for its numbers to be filled in.
StartSet empty_set(const PathClass& kind) {
  StartSet set;
  set.data.kind = kind;
  set.data.t.resize(kind.poses - 1);
  set.data.d.resize(kind.poses - 1 + kind.points);
  set.data.d_bar.resize(set.data.d.size());
  set.roots.resize(static_cast<std::size_t>(known_count(kind)) * unknowns(kind.points));
  return set;
}

InstructionSet set_of(const TrackingOptions& means) {
  const auto here = instruction_sets();
  const bool has = means.set && std::find(here.begin(), here.end(), *means.set) != here.end();
  return has ? *means.set : here.back();
}

std::shared_ptr<const StartSet> find(const PathClass& kind, const TrackingOptions& means) {
  std::shared_ptr<const StartSet> best;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    auto found = find_start_set(kind, means, nullptr, seed);
    if (means.stop && means.stop->stopped()) return nullptr;
    if (!found || (best && found->count() <= best->count())) continue;
    best = std::make_shared<const StartSet>(std::move(*found));
    if (best->count() == known_count(kind)) break;
  }
  return best;
}

}  // namespace

std::filesystem::path start_file(const std::filesystem::path& folder, const PathClass& kind,
                                 const TrackingOptions& means) {
  return folder / ("path-start-" + std::to_string(kind.poses) + "-" + std::to_string(kind.points) +
                   "-" + name(set_of(means)));
}

std::optional<StartSet> read_start_set(const std::filesystem::path& file, const PathClass& kind) {
  StartSet set = empty_set(kind);
  std::size_t count = 0;
  for_each_number(std::as_const(set), [&](double) { ++count; });
  const auto numbers = read_numbers(file, key_of(kind), count);
  if (!numbers || numbers->size() != count) return std::nullopt;
  auto next = numbers->begin();
  for_each_number(set, [&](double& x) { x = *next++; });
  return set;
}

bool write_start_set(const std::filesystem::path& file, const StartSet& set) {
  std::vector<double> numbers;
  for_each_number(set, [&](double x) { numbers.push_back(x); });
  return write_numbers(file, key_of(set.data.kind), numbers);
}

std::shared_ptr<const StartSet> start_set(const PathClass& kind,
                                          const std::filesystem::path& folder,
                                          const TrackingOptions& means) {
  static std::mutex guard;
  static std::map<std::tuple<int, InstructionSet>, std::shared_ptr<const StartSet>> kept;
  const std::tuple key(kind.poses, set_of(means));
  {
    const std::scoped_lock lock(guard);
    if (const auto at = kept.find(key); at != kept.end()) return at->second;
  }
  // Without the lock: two threads that ask at once find the same.
  std::shared_ptr<const StartSet> set;
  const auto file = folder.empty() ? folder : start_file(folder, kind, means);
  if (!folder.empty()) {
    if (auto read = read_start_set(file, kind)) {
      set = std::make_shared<const StartSet>(std::move(*read));
    }
  }
  if (!set) {
    set = find(kind, means);
    if (!set) return nullptr;
    const bool complete = set->count() == known_count(kind);
    if (!folder.empty() && complete) write_start_set(file, *set);
  }
  const std::scoped_lock lock(guard);
  return kept.try_emplace(key, set).first->second;
}

}  // namespace cognate::synthesis::nine_point
