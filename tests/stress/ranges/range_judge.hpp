/// @file What an analysis reports, held against the truth value by value.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/evaluation/result.hpp"
#include "tests/stress/ranges/range_stress.hpp"

namespace cognate::stress {

/// Analyses one file and compares.
class RangeJudge {
 public:
  RangeJudge(std::string file, RangeTally& tally);

  /// Whether the file was read.
  bool is_read() const { return problem_.has_value(); }

  /// What the analysis says of it.
  std::optional<double> number_said(const std::string& name) const;
  void number(const std::string& name, std::optional<double> truth, double tolerance);
  /// That the fact is the truth or beyond it, in the direction `sense`.
  void number_within(const std::string& name, double truth, double tolerance, int sense);
  void text(const std::string& name, const std::string& truth);
  void flag(const std::string& name, bool truth);
  /// The drive angles of landmarks of a kind, but for whole turns.
  void landmarks(const std::vector<std::string>& kinds, const std::vector<double>& truth,
                 double tolerance);
  /// That all these are among them.
  void has_landmarks(const std::string& kind, const std::vector<double>& truth, double tolerance);
  void is_true(const std::string& name, bool holds, const std::string& why);

  const problems::AnalysisResult& result() const { return result_; }

 private:
  template <class T>
  std::optional<T> quantity(const std::string& name) const;
  std::vector<double> places(const std::vector<std::string>& kinds) const;  ///< degrees
  void count(const std::string& name, bool agrees, const std::string& why);

  std::string file_;
  RangeTally& tally_;
  std::optional<problems::AnalysisProblem> problem_;
  problems::AnalysisResult result_;
};

}  // namespace cognate::stress
