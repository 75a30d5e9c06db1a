// Every class of fault in a function problem, with its exact place and what its message must say.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/reading/fault_cases.hpp"

namespace cognate::problems::function_faults_test {
namespace {

// A function problem with `lines` after its ranges: the first of them is line 7.
std::string function(const std::string& lines) {
  return "kind = \"function-generation\"\n[target]\nfunction = \"x^2\"\ndomain = [1, 2]\n"
         "input_range_deg = 60\noutput_range_deg = 90\n" +
         lines;
}

std::string target_function(const std::string& expression) {
  return "kind = \"function-generation\"\n[target]\nfunction = " + expression +
         "\ndomain = [0, 1]\ninput_range_deg = 60\noutput_range_deg = 90\n";
}

// Pairs on line 3, `lines` from line 4.
std::string pairs(const std::string& rows, const std::string& lines = "") {
  return "kind = \"function-generation\"\n[target]\npairs_deg = " + rows + "\n" + lines;
}

std::string table(const std::string& rows, const std::string& lines = "") {
  return "kind = \"function-generation\"\n[target]\ntable = " + rows +
         "\ninput_range_deg = 60\noutput_range_deg = 90\n" + lines;
}

const std::vector<FaultCase> kFunctionCases = {
    {"NothingToGenerate",
     "kind = \"function-generation\"\n[target]\n",
     {{2, 1, "expected one of function (with domain), table and pairs_deg"}}},
    {"CertificateOfMinimax",
     "kind = \"function-generation\"\n[target]\npairs_deg = [[0, 0], [10, 8], [20, 15]]\n"
     "objective = \"minimax\"\n[solve]\ncertify = true\n",
     {{6, 11, "expected objective = \"least-squares\""}}},
    {"TwoTargets",
     function("table = [[0, 0], [1, 1], [2, 2]]\n"),
     {{7, 9, "is given beside target.function"}}},
    {"DomainMissing",
     "kind = \"function-generation\"\n[target]\nfunction = \"x\"\nrelation = \"angles\"\n",
     {{2, 1, "target.domain is missing"}}},
    {"DomainEmpty",
     "kind = \"function-generation\"\n[target]\nfunction = \"x\"\ndomain = [1, 1]\n"
     "relation = \"angles\"\n",
     {{4, 10, "target.domain is empty"}}},
    {"DomainInDegrees",
     "kind = \"function-generation\"\n[target]\nfunction = \"x\"\ndomain = [0, 90]\n"
     "relation = \"angles\"\n",
     {{4, 10, "spans 90 radians"}}},
    {"RangesMissing",
     "kind = \"function-generation\"\n[target]\nfunction = \"x\"\ndomain = [0, 1]\n",
     {{2, 1, "target.input_range_deg is missing"}, {2, 1, "target.output_range_deg is missing"}}},
    {"RangeWithRelation",
     function("relation = \"angles\"\n"),
     {{5, 19, "is given, but with a relation"}, {6, 20, "is given, but with a relation"}}},
    {"RangeZero",
     "kind = \"function-generation\"\n[target]\nfunction = \"x\"\ndomain = [0, 1]\n"
     "input_range_deg = 0\noutput_range_deg = 400\n",
     {{5, 19, "is 0; expected an angle"},
      {6, 20, "is 400; expected an angle in degrees from -360 to 360"}}},
    {"ExpressionUnknownName",
     target_function("\"x + yy\""),
     {{3, 17, "cannot be read from \"yy\" on; known are the variable x"}}},
    {"ExpressionUnknownNameInLiteralString", target_function("'x + yy'"), {{3, 17, "\"yy\""}}},
    {"ExpressionWithEscapes", target_function("\"\\u0078 + yy\""), {{3, 12, "\"yy\""}}},
    {"ExpressionOpen", target_function("\"sin(x\""), {{3, 18, "Missing parenthesis"}}},
    {"ExpressionEmpty", target_function("\"\""), {{3, 13, "Expression is empty"}}},
    {"ExpressionAssigns", target_function("\"x = 3\""), {{3, 15, "contains an assignment"}}},
    {"ExpressionOfTwo", target_function("\"x, 3\""), {{3, 14, "has several values"}}},
    {"ExpressionWrongType", target_function("3"), {{3, 12, "is an integer; expected a string"}}},
    {"NotFiniteInside", target_function("\"1/(x - 0.5)\""), {{3, 12, "is inf at x = 0.5"}}},
    {"NotFiniteAtEnd", target_function("\"log(x)\""), {{3, 12, "is -inf at x = 0"}}},
    {"NotFiniteAtASampleOnly",
     target_function("\"sin(x - 1/60)/(x - 1/60)\""),
     {{3, 12, "is not a number (NaN) at the sample x = 0.0166"}}},
    {"PoleBetweenSamples",
     target_function("\"1/(x - 0.33333333)\""),
     {{3, 12, "has a pole near x = 0.33333333, where"}}},
    {"JumpAtAnEnd",
     target_function("\"x == 1\""),
     {{3, 12, "jumps at the end x = 1 of its domain"}}},
    {"NotReal",
     target_function("\"sqrt(x - 0.25)\""),
     {{3, 12, "is not a number (NaN) at x = 0;"}}},
    {"SameAtBothEnds", target_function("\"x*(1 - x)\""), {{3, 12, "at both ends of the domain"}}},
    {"TableTooShort", table("[[0, 0], [1, 1]]"), {{3, 9, "has 2 rows; expected 3 to 10000"}}},
    {"TableUnsorted",
     table("[[0, 0], [2, 1], [1, 2], [1, 3]]"),
     {{3, 26, "row 3 of target.table has x = 1 after 2"}, {3, 34, "x = 1 after 1"}}},
    {"TableWithDomain",
     table("[[0, 0], [1, 1], [2, 4]]", "domain = [0, 3]\n"),
     {{6, 10, "the domain of a table is its own x"}}},
    {"PairsTooFew", pairs("[[0, 0], [1, 1]]"), {{3, 13, "has 2 pairs"}}},
    {"ThreeEqualInputsExact",
     pairs("[[45, 50], [45, 80], [405, 110]]", "precision_points = 3\n"),
     {{3, 24, "pair 2 of target.pairs_deg has the input angle of pair 1"}, {3, 34, "pair 3"}}},
    {"EqualInputsDifferentOutputs",
     pairs("[[0, 50], [45, 80], [90, 1], [360, 110]]"),
     {{3, 42, "pair 4 of target.pairs_deg has the input angle of pair 1; expected one output"}}},
    {"TwoDifferentInputs",
     pairs("[[0, 50], [45, 80], [360, 50]]"),
     {{3, 13, "has 2 different input angles; expected at least 3"}}},
    {"PairsWithRange",
     pairs("[[0, 0], [1, 1], [2, 3]]", "input_range_deg = 3\n"),
     {{4, 19, "pairs are themselves angles"}}},
    {"PairsWithSamples",
     pairs("[[0, 0], [1, 1], [2, 3]]", "samples = 3\n"),
     {{4, 11, "remove it for pairs"}}},
    {"PrecisionPointsOtherThanPairs",
     pairs("[[0, 0], [1, 1], [2, 3], [4, 8]]", "precision_points = 3\n"),
     {{4, 20, "is 3 for 4 pairs"}}},
    {"SixExactPairs",
     pairs("[[0, 0], [1, 1], [2, 3], [4, 8], [5, 9], [6, 11]]", "objective = \"exact\"\n"),
     {{3, 13, "exact synthesis with 6 conditions; expected 3 to 5 conditions"}}},
    {"StartsForFourPoints",
     function("precision_points = 4\n[mechanism]\ninput_start_deg = 1\noutput_start_deg = 1\n"),
     {{10, 20, "is given, but 4 conditions leave only one start to be given"}}},
    {"StartForFivePoints",
     function("precision_points = 5\n[mechanism]\ninput_start_deg = 1\n"),
     {{9, 19, "is given, but 5 conditions leave no start to be given"}}},
    {"MultiplicityWithoutAt",
     function("multiplicity = [1, 2]\nprecision_points = 3\n"),
     {{7, 16, "is given without at"}}},
    {"MultiplicityForOtherPoints",
     function("at = [1, 1.5, 2]\nmultiplicity = [1, 2]\n"),
     {{8, 16, "has 2 entries for 3 precision points"}}},
    {"MultiplicityTooHigh",
     function("at = [1, 1.5]\nmultiplicity = [3, 3]\n"),
     {{8, 16, "makes 6 conditions; expected 3 to 5"}}},
    {"MultiplicityNoInteger",
     function("at = [1, 1.5]\nmultiplicity = [1.5, 2]\n"),
     {{8, 17, "an integer from 1 to 5"}}},
    {"MultiplicityOfATable",
     table("[[0, 0], [1, 1], [2, 4]]", "at = [0, 1]\nmultiplicity = [1, 2]\n"),
     {{7, 16, "derivatives, which a table does not have"}}},
    {"MultiplicityOfPairs",
     pairs("[[0, 0], [1, 1], [2, 3]]", "precision_points = 3\nmultiplicity = [1, 1, 1]\n"),
     {{5, 16, "is for a function; expected derivatives = [[...], ...]"}}},
    {"DerivativesOfAFunction",
     function("at = [1, 1.5, 2]\nderivatives = [[], [1], []]\n"),
     {{8, 15, "is for pairs; expected multiplicity"}}},
    {"DerivativesForOtherPairs",
     pairs("[[0, 0], [30, 20]]", "derivatives = [[1]]\nprecision_points = 3\n"),
     {{4, 15, "has 1 entries for the 2 of target.pairs_deg"}}},
    {"DerivativesTooMany",
     pairs("[[0, 0], [30, 20]]", "derivatives = [[1, 2, 3], [1]]\nobjective = \"exact\"\n"),
     {{3, 13, "exact synthesis with 6 conditions"}}},
    {"DerivativesOfWrongType",
     pairs("[[0, 0], [30, 20]]", "derivatives = [1, [\"x\"]]\nprecision_points = 3\n"),
     {{4, 16, "is an integer; expected an array of numbers"},
      {4, 20, "is \"x\"; expected a number"}}},
    {"DerivativesFitted",
     pairs("[[0, 0], [30, 20], [40, 50]]", "derivatives = [[1], [], []]\n"),
     {{4, 15, "is for exact synthesis"}}},
    {"BestByWithoutPrecisionPoints",
     function("[solve]\nbest_by = \"error\"\n"),
     {{8, 11, "chooses among exact designs"}}},
    {"SliderCrankWithLengths",
     "kind = \"function-generation\"\n[mechanism]\ntype = \"slider-crank\"\ncrank = 1\n[target]\n"
     "pairs = [[0, 1], [20, 2], [40, 4]]\nprecision_points = 3\n[bounds]\nrocker = [1, 2]\n"
     "[constraints]\nclass = \"grashof\"\n",
     {{4, 1, "unknown key \"crank\" in [mechanism]"},
      {9, 10, "has no meaning for a slider-crank"},
      {11, 9, "is Grashof's of a four-bar"}}},
    {"OffsetBesideFivePoints",
     "kind = \"function-generation\"\n[mechanism]\ntype = \"slider-crank\"\noffset = 1\n[target]\n"
     "pairs = [[0, 1], [20, 2], [40, 4], [50, 5], [60, 7]]\nprecision_points = 5\n",
     {{4, 10, "is given, but five conditions determine it; remove it or give fewer"}}},
    {"OffsetBesideBothStarts",
     "kind = \"function-generation\"\n[mechanism]\ntype = \"slider-crank\"\noffset = 1\n"
     "input_start_deg = 3\noutput_start = 5\n[target]\n"
     "pairs = [[0, 1], [20, 2], [40, 4]]\nprecision_points = 3\n",
     {{6, 16, "is given, but 3 conditions and the offset leave only one start to be given"}}},
    {"OffsetBesideFourPointsAndAStart",
     "kind = \"function-generation\"\n[mechanism]\ntype = \"slider-crank\"\noffset = 1\n"
     "output_start = 5\n[target]\npairs = [[0, 1], [20, 2], [40, 4], [60, 5]]\n"
     "precision_points = 4\n",
     {{5, 16, "is given, but 4 conditions and the offset leave no start to be given"}}},
    {"OffsetOutsideItsBounds",
     "kind = \"function-generation\"\n[mechanism]\ntype = \"slider-crank\"\noffset = 9\n[target]\n"
     "pairs = [[0, 1], [20, 2], [40, 4]]\nprecision_points = 3\n[bounds]\noffset = [1, 2]\n",
     {{4, 10, "is 9, outside its bounds; bounds.offset allows [1, 2]"}}},
    {"OffsetOfAFourBar",
     function("precision_points = 3\n[mechanism]\noffset = 1\n"),
     {{9, 1, "unknown key \"offset\""}}},
    {"SliderCrankPairsInDegrees",
     "kind = \"function-generation\"\n[mechanism]\ntype = \"slider-crank\"\n[target]\n"
     "pairs_deg = [[0, 1], [20, 2], [40, 4]]\nprecision_points = 3\n",
     {{4, 1, "expected one of function (with domain), table and pairs"},
      {5, 1, "unknown key \"pairs_deg\""}}},
    {"SliderCrankWithoutTravel",
     "kind = \"function-generation\"\n[mechanism]\ntype = \"slider-crank\"\n[target]\n"
     "function = \"x\"\ndomain = [0, 1]\ninput_range_deg = 60\nprecision_points = 3\n",
     {{4, 1, "target.output_range is missing; expected a displacement"}}},
    {"GeneratorOfAnotherType",
     function("precision_points = 3\n[mechanism]\ntype = \"guide-bar\"\n"),
     {{9, 8, "allowed are \"four-bar\", \"slider-crank\""}}},
    {"SixPoints",
     function("precision_points = 6\n[mechanism]\ninput_start_deg = 1\noutput_start_deg = 1\n"),
     {{7, 20, "is 6; expected an integer from 3 to 5"}}},
    {"AtOutsideDomain",
     function("at = [1, 1.5, 2.5]\n[mechanism]\ninput_start_deg = 1\noutput_start_deg = 1\n"),
     {{7, 15, "entry 3 of target.at is 2.5; expected x from 1 to 2"}}},
    {"AtRepeats",
     function("at = [1, 1.5, 1.5]\n[mechanism]\ninput_start_deg = 1\noutput_start_deg = 1\n"),
     {{7, 15, "is 1.5 after 1.5; expected increasing x"}}},
    {"AtWholeTurnApart",
     "kind = \"function-generation\"\n[target]\nfunction = \"x\"\ndomain = [0, 1]\nat = [0, 0.5, "
     "1]\n"
     "input_range_deg = -360\noutput_range_deg = 60\n[mechanism]\ninput_start_deg = 1\n"
     "output_start_deg = 1\n",
     {{5, 6, "a whole turn of the input apart"}}},
    {"ObjectiveAndPrecisionPoints",
     function("precision_points = 3\nobjective = \"minimax\"\n[mechanism]\ninput_start_deg = 1\n"
              "output_start_deg = 1\n"),
     {{8, 13, "\"minimax\" beside precision points"}}},
    {"SamplesTwice",
     function("samples = 9\n[solve]\nsamples = 9\n"),
     {{9, 11, "give target.samples or solve.samples, not both"}}},
    {"SamplesAndSampleAt",
     function("samples = 9\nsample_at = [1, 1.5, 2]\n"),
     {{7, 11, "is given beside sample_at"}}},
    {"SampleOutsideDomain",
     function("sample_at = [0, 1.5, 2]\n"),
     {{7, 14, "is 0; expected x from 1 to 2"}}},
    {"StartTwice",
     function("[mechanism]\nstart = \"outer-dead-centre\"\ninput_start_deg = 3\n"),
     {{9, 19, "is given beside mechanism.start"}}},
    {"StartMisspelt",
     function("[mechanism]\nstart = \"outer-dead-center\"\n"),
     {{8, 9, "perhaps for \"outer-dead-centre\""}}},
    {"ExactAtDeadCentre",
     function("precision_points = 3\n[mechanism]\nstart = \"inner-dead-centre\"\n"),
     {{9, 9, "depends on the lengths sought"}}},
    {"ExactWithLengths",
     pairs("[[0, 0], [1, 1], [2, 3]]",
           "precision_points = 3\n[mechanism]\ncrank = 1\nrocker = 2\nframe = 3\n"),
     {{7, 10, "exact synthesis finds every ratio"}, {8, 9, "is given beside crank"}}},
    {"StartOutsideBounds",
     function("[mechanism]\ninput_start_deg = 50\n[bounds]\ninput_start_deg = [0, 40]\n"),
     {{8, 19, "lies outside bounds.input_start_deg"}}},
    {"ScaleOutsideBounds",
     function("[bounds]\nlength = [5, 60]\n"),
     {{8, 10, "excludes crank = 1, which is the scale"}}},
    {"CeresWithMinimax",
     function("objective = \"minimax\"\n[solve]\nsolver = \"ceres\"\n"),
     {{9, 10, "but the objective is \"minimax\""}}},
    {"LossWithMinimax",
     function("objective = \"minimax\"\n[solve]\nloss = \"cauchy\"\nloss_scale = 0.1\n"),
     {{9, 8, "belongs to least squares"}, {10, 14, "belongs to least squares"}}},
    {"PivotsHaveNoMeaning",
     function("[mechanism]\npivot_a = [0, 0]\n"),
     {{8, 1, "unknown key \"pivot_a\" in [mechanism]; allowed are"}}},
};

class FunctionFaults : public ::testing::TestWithParam<FaultCase> {};

TEST_P(FunctionFaults, EachAtItsPlace) {
  expect_faults(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Function, FunctionFaults, ::testing::ValuesIn(kFunctionCases),
                         name_of_case);

}  // namespace
}  // namespace cognate::problems::function_faults_test
