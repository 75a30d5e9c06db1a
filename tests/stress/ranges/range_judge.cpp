#include "tests/stress/ranges/range_judge.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/read.hpp"

namespace cognate::stress {
namespace {

/// Those of `wanted` that are not among `all`, but for whole turns.
std::string missing(const std::vector<double>& wanted, const std::vector<double>& all,
                    double tolerance) {
  std::string text;
  for (const double place : wanted) {
    const bool found = std::ranges::any_of(all, [&](double other) {
      return std::abs(std::remainder(other - place, 360)) <= tolerance;
    });
    if (!found) text += fmt::format(" {:.12g}", place);
  }
  return text;
}

}  // namespace

int RangeTally::all_disagreements() const {
  int all = 0;
  for (const auto& [name, number] : disagreements) all += number;
  return all;
}

int RangeTally::all_compared() const {
  int all = 0;
  for (const auto& [name, number] : compared) all += number;
  return all;
}

RangeJudge::RangeJudge(std::string file, RangeTally& tally)
    : file_(std::move(file)), tally_(tally) {
  auto problem = problems::parse_task<problems::AnalysisProblem>(file_);
  if (!problem) {
    count("file", false, problem.error().front().message);
    return;
  }
  problem_ = std::move(*problem);
  result_ = problems::analyse(*problem_, problems::Run{.threads = 1});
}

template <class T>
std::optional<T> RangeJudge::quantity(const std::string& name) const {
  const auto found = std::ranges::find(result_.quantities, name, &problems::Quantity::name);
  if (found == result_.quantities.end()) return std::nullopt;
  return std::get<T>(found->value);
}

void RangeJudge::count(const std::string& name, bool agrees, const std::string& why) {
  ++tally_.compared[name];
  if (!agrees && tally_.disagreements[name]++ == 0) {
    tally_.first[name] = "# " + name + ": " + why + "\n" + file_;
  }
}

std::optional<double> RangeJudge::number_said(const std::string& name) const {
  return quantity<double>(name);
}

void RangeJudge::number(const std::string& name, std::optional<double> truth, double tolerance) {
  const auto said = quantity<double>(name);
  const auto text = [](std::optional<double> x) { return x ? fmt::format("{:.15g}", *x) : "none"; };
  const bool agrees =
      said.has_value() == truth.has_value() && (!said || std::abs(*said - *truth) <= tolerance);
  count(name, agrees, fmt::format("{} for {}", text(said), text(truth)));
}

void RangeJudge::number_within(const std::string& name, double truth, double tolerance, int sense) {
  const auto said = quantity<double>(name);
  count(name, said && sense * (*said - truth) >= -tolerance,
        fmt::format("not up to {:.15g}", truth));
}

void RangeJudge::text(const std::string& name, const std::string& truth) {
  const auto said = quantity<std::string>(name).value_or("");
  count(name, said == truth, fmt::format("\"{}\" for \"{}\"", said, truth));
}

void RangeJudge::flag(const std::string& name, bool truth) {
  const auto said = quantity<bool>(name);
  count(name, said == truth,
        fmt::format("{} for {}", said ? (*said ? "true" : "false") : "none", truth));
}

std::vector<double> RangeJudge::places(const std::vector<std::string>& kinds) const {
  std::vector<double> said;
  for (const auto& landmark : result_.landmarks) {
    if (std::ranges::find(kinds, landmark.kind) == kinds.end()) continue;
    said.push_back(landmark.drive * 180 / kPi);
  }
  return said;
}

void RangeJudge::landmarks(const std::vector<std::string>& kinds, const std::vector<double>& truth,
                           double tolerance) {
  const std::vector<double> said = places(kinds);
  count(kinds.front(),
        missing(truth, said, tolerance).empty() && missing(said, truth, tolerance).empty(),
        missing(truth, said, tolerance) + " missing," + missing(said, truth, tolerance) + " none");
}

void RangeJudge::has_landmarks(const std::string& kind, const std::vector<double>& truth,
                               double tolerance) {
  const std::string lost = missing(truth, places({kind}), tolerance);
  count(kind, lost.empty(), lost + " missing");
}

void RangeJudge::is_true(const std::string& name, bool holds, const std::string& why) {
  count(name, holds, why);
}

}  // namespace cognate::stress
