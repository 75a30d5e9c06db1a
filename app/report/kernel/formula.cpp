#include "app/report/kernel/formula.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

#include "analysis/numbers/constants.hpp"

namespace cognate::page {
namespace {

struct NamedFunction {
  std::string_view name;
  Formula::Unary value;
};

constexpr NamedFunction kFunctions[] = {
    {"sin", [](double x) { return std::sin(x); }},
    {"cos", [](double x) { return std::cos(x); }},
    {"tan", [](double x) { return std::tan(x); }},
    {"asin", [](double x) { return std::asin(x); }},
    {"acos", [](double x) { return std::acos(x); }},
    {"atan", [](double x) { return std::atan(x); }},
    {"sinh", [](double x) { return std::sinh(x); }},
    {"cosh", [](double x) { return std::cosh(x); }},
    {"tanh", [](double x) { return std::tanh(x); }},
    {"asinh", [](double x) { return std::asinh(x); }},
    {"acosh", [](double x) { return std::acosh(x); }},
    {"atanh", [](double x) { return std::atanh(x); }},
    {"exp", [](double x) { return std::exp(x); }},
    {"log", [](double x) { return std::log(x); }},
    {"ln", [](double x) { return std::log(x); }},
    {"log2", [](double x) { return std::log2(x); }},
    {"log10", [](double x) { return std::log10(x); }},
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"abs", [](double x) { return std::abs(x); }},
    {"sign", [](double x) { return x < 0   ? -1.0
                                   : x > 0 ? 1.0
                                           : 0.0; }},
    {"rint", [](double x) { return std::floor(x + 0.5); }}};

struct Operator {
  std::string_view sign;
  Formula::Binary value;
};

/// Operators from the loosest to the closest; of one row from left to right. Longer signs first.
constexpr std::size_t kLevels = 5;
const std::array<std::vector<Operator>, kLevels> kOperators{
    {{{"||", [](double a, double b) { return a != 0 || b != 0 ? 1.0 : 0.0; }}},
     {{"&&", [](double a, double b) { return a != 0 && b != 0 ? 1.0 : 0.0; }}},
     {{"<=", [](double a, double b) { return a <= b ? 1.0 : 0.0; }},
      {">=", [](double a, double b) { return a >= b ? 1.0 : 0.0; }},
      {"==", [](double a, double b) { return a == b ? 1.0 : 0.0; }},
      {"!=", [](double a, double b) { return a != b ? 1.0 : 0.0; }},
      {"<", [](double a, double b) { return a < b ? 1.0 : 0.0; }},
      {">", [](double a, double b) { return a > b ? 1.0 : 0.0; }}},
     {{"+", [](double a, double b) { return a + b; }},
      {"-", [](double a, double b) { return a - b; }}},
     {{"*", [](double a, double b) { return a * b; }},
      {"/", [](double a, double b) { return a / b; }}}}};

double plus(double a, double b) {
  return a + b;
}
double minus(double x) {
  return -x;
}
double power(double a, double b) {
  return std::pow(a, b);
}

}  // namespace

/// Reads by descending from the loosest operator to the closest.
class FormulaReader {
 public:
  FormulaReader(std::string_view text, std::span<const std::string_view> variables)
      : text_(text), variables_(variables) {}

  std::optional<Formula> read() {
    if (!choice() || !at_end()) return std::nullopt;
    return std::move(formula_);
  }

 private:
  using Action = Formula::Action;

  void skip_space() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  bool at_end() {
    skip_space();
    return at_ == text_.size();
  }
  bool take(std::string_view sign) {
    skip_space();
    if (!text_.substr(at_).starts_with(sign)) return false;
    at_ += sign.size();
    return true;
  }

  void put(Formula::Step step, int change) {
    formula_.steps_.push_back(step);
    height_ += change;
    formula_.depth_ = std::max(formula_.depth_, static_cast<std::size_t>(height_));
  }
  void put(double number) { put({.action = Action::number, .number = number}, 1); }
  void put(Formula::Unary value) { put({.action = Action::unary, .unary = value}, 0); }
  void put(Formula::Binary value) { put({.action = Action::binary, .binary = value}, -1); }

  // A file's text nests as deep as it is long, which the program limits.
  // NOLINTBEGIN(misc-no-recursion)
  bool choice() {
    if (!of_level(0)) return false;
    if (!take("?")) return true;
    if (!choice() || !take(":") || !choice()) return false;
    put({.action = Action::choice}, -2);
    return true;
  }

  bool of_level(std::size_t level) {
    if (level == kLevels) return signed_part();
    if (!of_level(level + 1)) return false;
    while (const Operator* next = taken(level)) {
      if (!of_level(level + 1)) return false;
      put(next->value);
    }
    return true;
  }

  const Operator* taken(std::size_t level) {
    const auto& row = kOperators[level];
    const auto found = std::ranges::find_if(row, [&](const Operator& o) { return take(o.sign); });
    return found == row.end() ? nullptr : &*found;
  }

  bool signed_part() {
    if (take("+")) return signed_part();
    if (!take("-")) return powers();
    if (!signed_part()) return false;
    put(minus);
    return true;
  }

  bool powers() {
    if (!primary()) return false;
    if (!take("^")) return true;
    if (!signed_part()) return false;
    put(power);
    return true;
  }

  bool primary() {
    if (take("(")) return choice() && take(")");
    skip_space();
    const char first = at_ < text_.size() ? text_[at_] : '\0';
    const bool is_name = std::isalpha(static_cast<unsigned char>(first)) != 0 || first == '_';
    return is_name ? named() : number();
  }

  bool number() {
    const std::string rest(text_.substr(at_));
    if (rest.find_first_of(".0123456789") != 0) return false;
    char* end = nullptr;
    const double value = std::strtod(rest.c_str(), &end);
    at_ += static_cast<std::size_t>(end - rest.c_str());
    put(value);
    return end != rest.c_str();
  }

  bool named() {
    const std::size_t begin = at_;
    const auto is_part = [&](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    };
    while (at_ < text_.size() && is_part(text_[at_])) ++at_;
    const std::string_view name = text_.substr(begin, at_ - begin);
    if (take("(")) return call(name);
    const auto variable = std::ranges::find(variables_, name);
    if (variable != variables_.end()) {
      const auto index = static_cast<std::size_t>(variable - variables_.begin());
      put({.action = Action::variable, .variable = index}, 1);
      return true;
    }
    if (name != "pi" && name != "e") return false;
    put(name == "pi" ? kPi : std::numbers::e);
    return true;
  }

  bool call(std::string_view name) {
    const auto function = std::ranges::find(kFunctions, name, &NamedFunction::name);
    if (function != std::end(kFunctions)) {
      if (!choice() || !take(")")) return false;
      put(function->value);
      return true;
    }
    return name == "atan2" ? folded([](double y, double x) { return std::atan2(y, x); }, 2) == 2
           : name == "min" ? folded([](double a, double b) { return std::min(a, b); }) > 0
           : name == "max" ? folded([](double a, double b) { return std::max(a, b); }) > 0
           : name == "sum" ? folded(plus) > 0
           : name == "avg" ? average()
                           : false;
  }

  bool average() {
    const int count = folded(plus);
    if (count == 0) return false;
    put(double(count));
    put([](double a, double b) { return a / b; });
    return true;
  }

  /// Of how many arguments, behind the bracket that opens, `value` was put; 0 where they are none
  /// or more than `most`.
  int folded(Formula::Binary value, int most = 1 << 20) {
    int count = 0;
    do {
      if (!choice() || ++count > most) return 0;
      if (count > 1) put(value);
    } while (take(","));
    return take(")") ? count : 0;
  }
  // NOLINTEND(misc-no-recursion)

  std::string_view text_;
  std::span<const std::string_view> variables_;
  std::size_t at_ = 0;
  int height_ = 0;
  Formula formula_;
};

std::optional<Formula> Formula::of(std::string_view text,
                                   std::span<const std::string_view> variables) {
  return FormulaReader(text, variables).read();
}

double Formula::operator()(std::span<const double> values) const {
  constexpr std::size_t kUsual = 32;
  std::array<double, kUsual> usual{};
  std::vector<double> more(depth_ > kUsual ? depth_ : 0);
  double* const stack = more.empty() ? usual.data() : more.data();
  double* top = stack;  // one past the last value
  for (const Step& step : steps_) {
    switch (step.action) {
      case Action::number:
        *top++ = step.number;
        break;
      case Action::variable:
        *top++ = values[step.variable];
        break;
      case Action::unary:
        top[-1] = step.unary(top[-1]);
        break;
      case Action::binary:
        --top;
        top[-1] = step.binary(top[-1], top[0]);
        break;
      case Action::choice:
        top -= 2;
        top[-1] = top[-1] != 0 ? top[0] : top[1];
    }
  }
  return top[-1];
}

bool Formula::uses(std::size_t variable) const {
  return std::ranges::any_of(steps_, [&](const Step& step) {
    return step.action == Action::variable && step.variable == variable;
  });
}

}  // namespace cognate::page
