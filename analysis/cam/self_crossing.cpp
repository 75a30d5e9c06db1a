#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>

#include "analysis/cam/profile.hpp"

namespace cognate::cam {

bool crosses_itself(const std::vector<ProfilePoint>& polygon) {
  namespace bg = boost::geometry;
  bg::model::ring<bg::model::d2::point_xy<double>> ring;
  for (const ProfilePoint& point : polygon)
    bg::append(ring, bg::make<bg::model::d2::point_xy<double>>(point.at.x, point.at.y));
  bg::correct(ring);
  return bg::intersects(ring);
}

}  // namespace cognate::cam
