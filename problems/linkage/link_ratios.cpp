#include "problems/linkage/link_ratios.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cognate::problems {
namespace {

using L = Lengths<double>;
constexpr std::array<double L::*, 4> kAllLinks{&L::crank, &L::coupler, &L::rocker, &L::frame};

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

double log_uniform(std::mt19937_64& random, double low, double high) {
  return std::exp(uniform(random, std::log(low), std::log(high)));
}

/// Three links dealt at random to the places other than `first`, which gets 1.
L deal(std::mt19937_64& random, double L::*first, std::array<double, 3> values) {
  for (std::size_t i = 2; i > 0; --i) std::swap(values[i], values[random() % (i + 1)]);
  L links{};
  links.*first = 1;
  std::size_t next = 0;
  for (const auto link : kAllLinks) {
    if (link != first) links.*link = values[next++];
  }
  return links;
}

/// A Grashof linkage whose shortest link is `shortest`: for others a and b the last is between
/// |a − b| + 1 and a + b − 1.
L grashof(std::mt19937_64& random, double L::*shortest, double largest) {
  const double a = log_uniform(random, 1, largest), b = log_uniform(random, 1, largest);
  const double last = uniform(random, std::abs(a - b) + 1, a + b - 1);
  return deal(random, shortest, {a, b, last});
}

/// A linkage without a fully turning link: for a ≥ b ≥ 1 the last is between the Grashof range and
/// what can be assembled, on either side.
L non_grashof(std::mt19937_64& random, double largest) {
  const double a = log_uniform(random, 1, largest), b = log_uniform(random, 1, largest);
  const double beyond = uniform(random, -1, 1);
  const bool above = random() % 2 == 0;
  const double last = above ? a + b + beyond : std::max(std::abs(a - b) + beyond, 1e-3);
  return deal(random, kAllLinks[random() % 4], {a, b, last});
}

L draw(std::mt19937_64& random, const std::optional<RequiredClass>& required, double largest) {
  if (!required) {
    return random() % 2 == 0 ? grashof(random, kAllLinks[random() % 4], largest)
                             : non_grashof(random, largest);
  }
  switch (*required) {
    case RequiredClass::crank_rocker:
      return grashof(random, &L::crank, largest);
    case RequiredClass::double_crank:
      return grashof(random, &L::frame, largest);
    case RequiredClass::rocker_crank:
      return grashof(random, &L::rocker, largest);
    case RequiredClass::double_rocker:
      return grashof(random, &L::coupler, largest);
    case RequiredClass::grashof:
      return grashof(random, kAllLinks[random() % 4], largest);
    case RequiredClass::triple_rocker:
    case RequiredClass::non_grashof:
      return non_grashof(random, largest);
  }
  return {};
}

}  // namespace

L random_ratios(std::mt19937_64& random, const std::optional<RequiredClass>& required,
                double largest) {
  L links = draw(random, required, std::max(largest, 1.001));
  for (const auto link : {&L::coupler, &L::rocker, &L::frame}) links.*link /= links.crank;
  links.crank = 1;
  return links;
}

}  // namespace cognate::problems
