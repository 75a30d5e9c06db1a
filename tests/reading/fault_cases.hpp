/// @file Faulty files as cases of a parametrised test.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "problems/read.hpp"

namespace cognate::problems {

/// A fault that must be found.
struct Expected {
  std::size_t line;
  std::size_t column;
  std::string says;  // a part of the message
};

/// A file and every fault that it has, in its order.
struct FaultCase {
  std::string name;
  std::string text;
  std::vector<Expected> faults;
};

inline void PrintTo(const FaultCase& c, std::ostream* out) {
  *out << c.text;
}

/// Reading gives exactly the faults of `c`, each at its place, saying what is wrong and what is
/// allowed.
inline void expect_faults(const FaultCase& c) {
  const auto task = parse_task(c.text);
  ASSERT_FALSE(task) << "no fault found";
  const std::vector<Fault>& faults = task.error();
  std::string all;
  for (const Fault& fault : faults) {
    all += std::to_string(fault.line) + ":" + std::to_string(fault.column) + ": " + fault.message +
           "\n";
    EXPECT_NE(fault.message.find("; "), std::string::npos)
        << "says what is wrong but not what is allowed: " << fault.message;
  }
  ASSERT_EQ(faults.size(), c.faults.size()) << all;
  for (std::size_t i = 0; i < faults.size(); ++i) {
    EXPECT_EQ(faults[i].line, c.faults[i].line) << all;
    EXPECT_EQ(faults[i].column, c.faults[i].column) << all;
    EXPECT_NE(faults[i].message.find(c.faults[i].says), std::string::npos)
        << "wanted: " << c.faults[i].says << "\n"
        << all;
  }
}

inline std::string name_of_case(const ::testing::TestParamInfo<FaultCase>& info) {
  return info.param.name;
}

}  // namespace cognate::problems
