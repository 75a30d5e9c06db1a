#include "app/documents/csv.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>

namespace cognate::app::csv_test {
namespace {

using problems::Column;

Column column(std::string name, std::vector<double> values) {
  return {std::move(name), "position", "A", "length", std::move(values)};
}

TEST(Csv, HasAHeaderAndARowForEachStep) {
  const std::vector<Column> columns = {column("crank_deg", {0, 90}), column("A_x", {0.1, -2e-9})};
  EXPECT_EQ(csv_text(columns), "crank_deg,A_x\r\n0,0.1\r\n90,-2e-09\r\n");
}

TEST(Csv, LeavesCellsEmptyThatHoldNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Column> columns = {column("a", {nan, 1}), column("b", {infinity, nan})};
  EXPECT_EQ(csv_text(columns), "a,b\r\n,\r\n1,\r\n");
}

TEST(Csv, WordsStandBeforeTheNumbers) {
  const std::vector<Column> columns = {column("a", {1, 2}), column("b", {3, 4})};
  EXPECT_EQ(csv_text(columns, {"task", {"start", "a,b"}}),
            "task,a,b\r\nstart,1,3\r\n\"a,b\",2,4\r\n");
}
TEST(Csv, QuotesNamesThatNeedIt) {
  const std::vector<Column> columns = {column("a,b", {}), column("say \"c\"", {}),
                                       column("two\nlines", {})};
  EXPECT_EQ(csv_text(columns), "\"a,b\",\"say \"\"c\"\"\",\"two\nlines\"\r\n");
}

TEST(Csv, NumbersReadBackToTheSameBits) {
  std::mt19937_64 random(7);
  std::vector<double> values;
  while (values.size() < 2000) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) values.push_back(value);
  }
  const std::vector<Column> columns = {column("x", values)};
  const std::string text = csv_text(columns);
  const char* at = text.data() + 3;  // past the header
  for (const double value : values) {
    double read = 0;
    at = std::from_chars(at, text.data() + text.size(), read).ptr + 2;
    ASSERT_EQ(read, value);
  }
}

TEST(Csv, NamesTheUnitOfLengths) {
  std::vector<Column> columns{{"crank_deg", "drive", "", "deg", {}},
                              {"C_x", "position", "C", "length", {}},
                              {"C_vx_per_s", "velocity", "C", "length/s", {}},
                              {"velocity_per_rad", "cam", "", "length/rad", {}},
                              {"C_curvature", "curvature", "C", "1/length", {}},
                              {"contact_stress", "cam", "", "N/length²", {}},
                              {"torque_N_m", "torque", "", "N m", {}}};
  EXPECT_EQ(csv_text(columns, {}, "mm"),
            "crank_deg,C_x_mm,C_vx_mm_per_s,velocity_mm_per_rad,C_curvature_per_mm,"
            "contact_stress_N_per_mm2,torque_N_m\r\n");
}

}  // namespace
}  // namespace cognate::app::csv_test
