#include "app/export/curve_table.hpp"

#include <array>
#include <limits>

#include "app/documents/csv.hpp"
#include "problems/basics/degrees.hpp"

namespace cognate::app {

std::string csv_text(const CamOutline& curve) {
  std::array<problems::Column, 6> columns;
  constexpr std::array kNames = {"cam_deg",  "x",        "y",
                                 "normal_x", "normal_y", "radius_of_curvature"};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    columns[i].name = kNames[i];
    columns[i].values.reserve(curve.points.size());
  }
  for (const auto& point : curve.points) {
    const double radius =
        point.curvature != 0 ? 1 / point.curvature : std::numeric_limits<double>::quiet_NaN();
    const std::array row = {problems::degrees(point.angle),
                            point.at.x,
                            point.at.y,
                            point.normal.x,
                            point.normal.y,
                            radius};
    for (std::size_t i = 0; i < row.size(); ++i) columns[i].values.push_back(row[i]);
  }
  return csv_text(columns);
}

}  // namespace cognate::app
