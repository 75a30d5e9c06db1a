#include "app/report/drawn_number.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/report/report_data.hpp"

namespace cognate::app {

nlohmann::ordered_json drawn(double x) {
  if (!std::isfinite(x)) return nullptr;
  return round_to_digits(x, kDrawnDigits);
}

}  // namespace cognate::app
