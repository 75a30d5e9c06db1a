#include "problems/evaluation/instant_geometry.hpp"

#include <array>
#include <cmath>
#include <optional>

#include "analysis/coupler_curve/path_curvature.hpp"
#include "analysis/coupler_curve/pole.hpp"
#include "analysis/coupler_curve/stationary_curvature.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/evaluation/drive_rows.hpp"

namespace cognate::problems {
namespace {

constexpr Vec2d kNowhere{kNaN, kNaN};

constexpr std::array kColumns = {
    "pole_x",
    "pole_y",
    "moving_centrode_u",
    "moving_centrode_v",
    "inflection_diameter",
    "inflection_centre_x",
    "inflection_centre_y",
    "return_centre_x",
    "return_centre_y",
    "tangential_diameter",
    "tangential_centre_x",
    "tangential_centre_y",
    "acceleration_pole_x",
    "acceleration_pole_y",
    "ball_x",
    "ball_y",
    "stationary_m",
    "stationary_n",
    "inflection_line_x",
    "inflection_line_y",
    "inflection_line_deg",
};
constexpr std::size_t kAccelerationColumn = 12, kLineColumn = 18;

using Row = std::array<double, kColumns.size()>;

/// α/ω² of the body; infinite where the drive stands still.
double spin_of(const Pole& pole, const DriveRate& rate) {
  return pole.spin + rate.acceleration / (pole.turn * rate.speed * rate.speed);
}

/// M or N; not a number where rounding alone keeps its inverse from zero.
double length(double inverse, const StationaryCubic& cubic) {
  constexpr double kRounding = 1e-13;
  return std::abs(inverse) * cubic.diameter > kRounding ? 1 / inverse : kNaN;
}

Row row_of(const BodyMotion<double, 3>& body, const Pole& pole, double spin) {
  const Vec2d moving = moving_centrode(body, pole).at;
  const Circle inflection = inflection_circle(pole);
  const Vec2d back = return_circle(pole).centre;
  const auto tangential =
      tangential_circle(pole, spin).value_or(Circle{.centre = kNowhere, .radius = kNaN});
  const Vec2d still = acceleration_pole(pole, spin);
  const auto cubic = circling_points(pole);
  const Vec2d ball = (cubic ? ball_point(*cubic) : std::nullopt).value_or(kNowhere);
  return {pole.at.x,
          pole.at.y,
          moving.x,
          moving.y,
          2 * inflection.radius,
          inflection.centre.x,
          inflection.centre.y,
          back.x,
          back.y,
          2 * tangential.radius,
          tangential.centre.x,
          tangential.centre.y,
          still.x,
          still.y,
          ball.x,
          ball.y,
          cubic ? length(cubic->inverse_m, *cubic) : kNaN,
          cubic ? length(cubic->inverse_n, *cubic) : kNaN,
          kNaN,
          kNaN,
          kNaN};
}

/// Of a body that slides: the line that its inflection circle has become and, for a drive that
/// moves, the acceleration pole on it. Empty without angular acceleration.
std::optional<Row> sliding_row(const BodyMotion<double, 3>& body, double h, const DriveRate& rate) {
  const auto line = inflection_line(body, h);
  if (!line) return std::nullopt;
  Row row;
  row.fill(kNaN);
  // O″ q̇² + O′ q̈ + φ″ q̇² i z = 0.
  const double square = rate.speed * rate.speed;
  const Vec2d acceleration = square * body.origin[2] + rate.acceleration * body.origin[1];
  const Vec2d still = body.origin[0] + (1 / (body.turn[1] * square)) * perp(acceleration);
  row[kAccelerationColumn] = still.x;
  row[kAccelerationColumn + 1] = still.y;
  row[kLineColumn] = line->through.x;
  row[kLineColumn + 1] = line->through.y;
  row[kLineColumn + 2] = degrees(std::atan2(line->direction.y, line->direction.x));
  return row;
}

}  // namespace

std::span<const char* const> instant_geometry_columns() {
  return kColumns;
}

bool is_inflection_line(const Column& column) {
  return column.quantity == "instant-geometry" &&
         column.name.find("_inflection_line_") != std::string::npos;
}

void InstantGeometryFiller::fill(ColumnPlan& plan, int row) {
  if (!motion_.move_to(drive_at(problem_.drive, row))) return;
  for (const auto& [number, first] : plan.instants) {
    const auto& body = motion_.bodies()[static_cast<std::size_t>(number)];
    const double scale = motion_.assembly_ranges().scale;
    const auto pole = cognate::pole(body, scale);
    const auto found = pole
                           ? std::optional(row_of(body, *pole, spin_of(*pole, problem_.drive.rate)))
                           : sliding_row(body, scale, problem_.drive.rate);
    if (!found) continue;
    const Row& values = *found;
    for (std::size_t i = 0; i < values.size(); ++i) {
      plan.columns[static_cast<std::size_t>(first) + i].values[static_cast<std::size_t>(row)] =
          values[i];
    }
  }
}

}  // namespace cognate::problems
