#include "analysis/train/gear_train.hpp"

#include <algorithm>

namespace cognate::train {
namespace {

using Row = std::vector<Fraction>;

void add_to(Row& row, int member, int coefficient) {
  if (member == kFrame) return;
  row[static_cast<std::size_t>(member)] += coefficient;
}

/// Linear equations in the speeds of `members`, with a right side for each input, brought to
/// reduced echelon form row by row.
class Equations {
 public:
  Equations(int members, std::size_t inputs)
      : members_(static_cast<std::size_t>(members)), width_(members_ + inputs) {}

  Row empty_row() const { return Row(width_, Fraction(0)); }
  std::size_t rank() const { return rows_.size(); }

  enum class Added { independent, follows, contradicts };

  Added add(Row row) {
    for (std::size_t i = 0; i < rows_.size(); ++i) subtract(row, row[pivots_[i]], rows_[i]);
    const auto end = row.begin() + static_cast<std::ptrdiff_t>(members_);
    const auto nonzero = [](const Fraction& entry) { return !entry.is_zero(); };
    const auto found = std::find_if(row.begin(), end, nonzero);
    if (found == end) {
      return std::any_of(end, row.end(), nonzero) ? Added::contradicts : Added::follows;
    }
    const Fraction pivot = *found;
    const auto place = static_cast<std::size_t>(found - row.begin());
    for (Fraction& entry : row) entry /= pivot;
    for (Row& other : rows_) subtract(other, other[place], row);
    rows_.push_back(std::move(row));
    pivots_.push_back(place);
    return Added::independent;
  }

  /// The right side of `member`; empty where its speed is not determined.
  Row solution(std::size_t member) const {
    const auto found = std::ranges::find(pivots_, member);
    if (found == pivots_.end()) return {};
    const Row& row = rows_[static_cast<std::size_t>(found - pivots_.begin())];
    for (std::size_t i = 0; i < members_; ++i) {
      if (i != member && !row[i].is_zero()) return {};
    }
    return {row.begin() + static_cast<std::ptrdiff_t>(members_), row.end()};
  }

 private:
  void subtract(Row& from, const Fraction times, const Row& row) {
    if (times.is_zero()) return;
    for (std::size_t i = 0; i < width_; ++i) {
      if (!row[i].is_zero()) from[i] -= times * row[i];
    }
  }

  std::size_t members_, width_;
  std::vector<Row> rows_;
  std::vector<std::size_t> pivots_;
};

Row mesh_row(const Equations& equations, const Mesh& mesh) {
  Row row = equations.empty_row();
  add_to(row, mesh.gears[0], mesh.teeth[0]);
  add_to(row, mesh.gears[1], -mesh.signed_teeth());
  add_to(row, mesh.carrier, mesh.signed_teeth() - mesh.teeth[0]);
  return row;
}

void add_conditions(const GearTrain& train, Equations& equations) {
  for (const Mesh& mesh : train.meshes) equations.add(mesh_row(equations, mesh));
  for (const int member : train.fixed) {
    Row row = equations.empty_row();
    add_to(row, member, 1);
    equations.add(std::move(row));
  }
  for (const auto& [one, other] : train.joined) {
    Row row = equations.empty_row();
    add_to(row, one, 1);
    add_to(row, other, -1);
    equations.add(std::move(row));
  }
}

void add_inputs(const std::vector<int>& inputs, Equations& equations, TrainSpeeds& speeds) {
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const Row before = equations.solution(static_cast<std::size_t>(inputs[k]));
    Row row = equations.empty_row();
    add_to(row, inputs[k], 1);
    add_to(row, static_cast<int>(row.size() - inputs.size() + k), 1);
    if (equations.add(std::move(row)) == Equations::Added::independent) continue;
    speeds.excess.push_back(static_cast<int>(k));
    const auto is_zero = [](const Fraction& share) { return share.is_zero(); };
    if (std::ranges::all_of(before, is_zero)) speeds.locked.push_back(static_cast<int>(k));
  }
}

}  // namespace

double TrainSpeeds::speed(int member, const std::vector<double>& inputs) const {
  double sum = 0;
  const Row& of = shares[static_cast<std::size_t>(member)];
  for (std::size_t k = 0; k < of.size(); ++k) sum += of[k].convert_to<double>() * inputs[k];
  return sum;
}

TrainSpeeds speeds_of(const GearTrain& train, const std::vector<int>& inputs) {
  TrainSpeeds speeds;
  Equations equations(train.members, inputs.size());
  add_conditions(train, equations);
  speeds.freedom = train.members - static_cast<int>(equations.rank());
  speeds.redundant = static_cast<int>(train.conditions() - equations.rank());
  add_inputs(inputs, equations, speeds);
  for (int member = 0; member < train.members; ++member) {
    speeds.shares.push_back(equations.solution(static_cast<std::size_t>(member)));
    if (speeds.shares.back().empty() && !inputs.empty()) speeds.undetermined.push_back(member);
  }
  return speeds;
}

}  // namespace cognate::train
