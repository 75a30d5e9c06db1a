/// @file A family of exact function generators as tables.
#pragma once

#include <string>
#include <vector>

#include "problems/function/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Whether two mechanisms of one type agree in assembly and in lengths, relative to their sizes.
bool same_lengths(const Design& a, const Design& b, double tolerance);

/// The designs for each value of a start, sorted into as many tables as there are solutions at
/// most, so that each goes on smoothly.
class FamilyTable {
 public:
  /// Of the start that is varied: whether it is the input's, and an angle rather than a
  /// displacement.
  FamilyTable(const FunctionProblem& problem, bool input, bool angle);

  /// Adds a row; a table whose solution does not exist there has none in it.
  void add(double start, const std::vector<const Design*>& designs);

  std::vector<Family> families() const { return families_; }

 private:
  using Row = std::vector<double>;

  Row row_of(const Design& design) const;
  std::size_t nearest_table(const Row& row, const std::vector<bool>& taken) const;
  void append(Family& family, double start, const Row& row) const;

  bool slider_ = false;
  bool angle_ = true;
  std::vector<std::string> names_;
  std::vector<Family> families_;
  std::vector<Row> last_;       ///< the last row of each table that has a solution
  std::vector<double> starts_;  ///< of the rows so far
};

}  // namespace cognate::problems
