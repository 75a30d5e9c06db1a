// A user's program that reads problems: a right one, and a wrong one by its faults.
#include <cognate/problems/read.hpp>

int main() {
  const auto right = cognate::problems::parse_problem(
      "kind = 'path-generation'\n[target]\npoints = [[0, 0], [1, 2], [3, 1]]\ntiming = 'free'\n");
  const auto wrong = cognate::problems::parse_problem("kind = 'path-generation'\n");
  return right && !wrong && !wrong.error().empty() ? 0 : 1;
}
