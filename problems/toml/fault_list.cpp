#include "problems/toml/fault_list.hpp"

#include <algorithm>
#include <tuple>

namespace cognate::problems::reading {

void FaultList::add(Where where, std::string message) {
  faults_.push_back({where.line, where.column, std::move(message)});
}

std::vector<Fault> FaultList::sorted() && {
  std::ranges::stable_sort(faults_, [](const Fault& a, const Fault& b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
  });
  if (faults_.size() > kMost) faults_.resize(kMost);
  return std::move(faults_);
}

}  // namespace cognate::problems::reading
