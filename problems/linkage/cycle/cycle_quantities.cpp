#include "problems/linkage/cycle/cycle_quantities.hpp"

namespace cognate::problems {

std::string list_of(std::string (*part)(const CycleDeclaration&), std::string_view last,
                    bool CycleDeclaration::*has) {
  std::string text, end;
  for (const CycleDeclaration& quantity : kCycleQuantities) {
    if (has && !(quantity.*has)) continue;
    if (!end.empty()) text += (text.empty() ? "" : ", ") + end;
    end = part(quantity);
  }
  return text.empty() ? end : text + std::string(last) + end;
}

std::string limit_keys(bool CycleDeclaration::*has) {
  const auto key = [](const CycleDeclaration& of) { return std::string(of.limit_key); };
  return "constraints." + list_of(key, " or ", has);
}

}  // namespace cognate::problems
