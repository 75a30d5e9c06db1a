/// The roots and reciprocals of each instruction set against 113 bits, in units in the last place.
#include "batch_roots.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "analysis/batch/instruction_set.hpp"

namespace cognate {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;

template <class Real>
void find_roots(InstructionSet set, const RootsTask<Real>& task) {
  switch (set) {
    case InstructionSet::scalar:
      return batch::scalar::find_roots(task);
#ifdef COGNATE_X86_KERNELS
    case InstructionSet::sse2:
      return batch::sse2::find_roots(task);
    case InstructionSet::avx2:
      return batch::avx2::find_roots(task);
    case InstructionSet::avx512:
      return batch::avx512::find_roots(task);
#else
    default:
      return;
#endif
  }
}

template <class Real>
struct Found {
  std::vector<Real> x, root, inverse, inverse_root;
  Found(InstructionSet set, std::vector<Real> given)
      : x(std::move(given)), root(x.size()), inverse(x.size()), inverse_root(x.size()) {
    find_roots<Real>(set, {x.data(), root.data(), inverse.data(), inverse_root.data(), x.size()});
  }
};

/// |value − exact| in units in the last place of the exact value.
template <class Real>
double ulps(Real value, const Quad& exact) {
  const double bound = std::abs(double(exact));
  const double unit = std::ldexp(double(std::numeric_limits<Real>::epsilon()), std::ilogb(bound));
  return std::abs(double(Quad(value) - exact)) / unit;
}

template <class Real>
class BatchRoots : public ::testing::Test {};
using Reals = ::testing::Types<double, float>;
TYPED_TEST_SUITE(BatchRoots, Reals);

TYPED_TEST(BatchRoots, AreWithinTheStatedUnits) {
  using Real = TypeParam;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> mantissa(1, 2);
  std::uniform_int_distribution<int> exponent(-40, 2);
  std::vector<Real> x(32000);
  for (Real& one : x) one = static_cast<Real>(std::ldexp(mantissa(random), exponent(random)));
  for (const InstructionSet set : instruction_sets()) {
    const Found<Real> found(set, x);
    double root = 0, inverse = 0, inverse_root = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      root = std::max(root, ulps(found.root[i], sqrt(Quad(x[i]))));
      inverse = std::max(inverse, ulps(found.inverse[i], 1 / Quad(x[i])));
      inverse_root = std::max(inverse_root, ulps(found.inverse_root[i], 1 / sqrt(Quad(x[i]))));
    }
    this->RecordProperty(std::string(name(set)) + "_root_ulps", std::to_string(root));
    this->RecordProperty(std::string(name(set)) + "_inverse_ulps", std::to_string(inverse));
    this->RecordProperty(std::string(name(set)) + "_inverse_root_ulps",
                         std::to_string(inverse_root));
    EXPECT_LE(root, 0.64) << name(set);
    EXPECT_LE(inverse, 1.9) << name(set);
    EXPECT_LE(inverse_root, 2.7) << name(set);
  }
}

TYPED_TEST(BatchRoots, AreRightAtZeroAndBelow) {
  using Real = TypeParam;
  std::vector<Real> x(16, Real(1));
  x[3] = 0;
  x[4] = -Real(1);
  x[5] = std::numeric_limits<Real>::quiet_NaN();
  for (const InstructionSet set : instruction_sets()) {
    const Found<Real> found(set, x);
    EXPECT_EQ(found.root[0], 1) << name(set);
    EXPECT_EQ(found.root[3], 0) << name(set);
    EXPECT_EQ(found.inverse_root[3], std::numeric_limits<Real>::infinity()) << name(set);
    EXPECT_TRUE(std::isnan(found.root[4])) << name(set);
    EXPECT_TRUE(std::isnan(found.root[5])) << name(set);
  }
}

}  // namespace
}  // namespace cognate
