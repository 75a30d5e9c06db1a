#include "problems/linkage/transmission_hessian.hpp"

namespace cognate::problems {

TransmissionHessian transmission_hessian(const Lengths<double>& links, double cosine, double sine) {
  enum { a, b, c, f, theta };
  const auto& [l1, l2, l3, l4] = links;
  const double d2 = l1 * l1 + l4 * l4 - 2 * l1 * l4 * cosine;
  TransmissionHessian out{};
  const auto set = [&](int i, int j, double value) { out[i][j] = out[j][i] = value; };
  set(b, b, (l3 - d2 / l3) / (l2 * l2 * l2));
  set(c, c, (l2 - d2 / l2) / (l3 * l3 * l3));
  set(b, c, -0.5 / (l2 * l2) - 0.5 / (l3 * l3) - 0.5 * d2 / (l2 * l2 * l3 * l3));
  // Through d²: its slopes, then its second derivatives.
  const double by_d2 = -0.5 / (l2 * l3);
  const std::array slopes{2 * (l1 - l4 * cosine), 0.0, 0.0, 2 * (l4 - l1 * cosine),
                          2 * l1 * l4 * sine};
  for (const int i : {a, f, theta}) {
    set(i, b, -by_d2 / l2 * slopes[i]);
    set(i, c, -by_d2 / l3 * slopes[i]);
  }
  set(a, a, 2 * by_d2);
  set(f, f, 2 * by_d2);
  set(a, f, -2 * cosine * by_d2);
  set(a, theta, 2 * l4 * sine * by_d2);
  set(f, theta, 2 * l1 * sine * by_d2);
  set(theta, theta, 2 * l1 * l4 * cosine * by_d2);
  return out;
}

}  // namespace cognate::problems
