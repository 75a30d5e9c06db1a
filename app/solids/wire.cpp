#include "app/solids/wire.hpp"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <stdexcept>
#include <vector>

#include "analysis/numbers/constants.hpp"

namespace cognate::app {
namespace {

constexpr double kSmoothTurn = 20 * kTurn / 360;

/// A line, an arc, or a curve through more than two corners.
class WireMaker {
 public:
  WireMaker(const SolidLoop& loop, double z, double millimetres) : z_(z) {
    for (const PlanCorner& corner : loop.corners) {
      const PlanCorner scaled{millimetres * corner.at, corner.bulge};
      if (!corners_.empty() && norm(scaled.at - corners_.back().at) < kOnePoint)
        corners_.pop_back();
      corners_.push_back(scaled);
    }
    if (corners_.size() > 1 && norm(corners_.front().at - corners_.back().at) < kOnePoint) {
      corners_.pop_back();
    }
    if (corners_.size() < 2) throw std::runtime_error("its outline has no extent");
  }

  TopoDS_Wire make() {
    const std::size_t count = corners_.size();
    std::size_t first = 0;
    while (first < count && is_smooth(first)) ++first;
    if (first == count) return closed_curve();
    const TopoDS_Vertex begin = vertex(first);
    TopoDS_Vertex from = begin;
    for (std::size_t i = first; i < first + count;) {
      std::size_t end = i + 1;
      while (end < first + count && is_smooth(end)) ++end;
      const TopoDS_Vertex to = end == first + count ? begin : vertex(end);
      wire_.Add(edge(i, end, from, to));
      from = to;
      i = end;
    }
    return wire_.Wire();
  }

 private:
  const PlanCorner& corner(std::size_t i) const { return corners_[i % corners_.size()]; }

  gp_Pnt point(const Vec2d& at) const { return {at.x, at.y, z_}; }

  TopoDS_Vertex vertex(std::size_t i) const {
    return BRepBuilderAPI_MakeVertex(point(corner(i).at)).Vertex();
  }

  /// Whether two lines meet at the corner as chords of one curve do.
  bool is_smooth(std::size_t i) const {
    const std::size_t before = i + corners_.size() - 1;
    if (corner(before).bulge != 0 || corner(i).bulge != 0) return false;
    const Vec2d in = corner(i).at - corner(before).at, out = corner(i + 1).at - corner(i).at;
    return std::abs(std::atan2(cross(in, out), dot(in, out))) < kSmoothTurn;
  }

  TopoDS_Edge edge(std::size_t i, std::size_t end, const TopoDS_Vertex& from,
                   const TopoDS_Vertex& to) const {
    if (end > i + 1) return BRepBuilderAPI_MakeEdge(curve(i, end), from, to).Edge();
    const PlanCorner& begin = corner(i);
    if (begin.bulge == 0) return BRepBuilderAPI_MakeEdge(from, to).Edge();
    const Vec2d half = 0.5 * (corner(end).at - begin.at);
    const gp_Pnt middle = point(begin.at + half - begin.bulge * perp(half));
    const GC_MakeArcOfCircle arc(point(begin.at), middle, point(corner(end).at));
    return BRepBuilderAPI_MakeEdge(arc.Value(), from, to).Edge();
  }

  Handle(Geom_BSplineCurve) curve(std::size_t i, std::size_t end, bool closed = false) const {
    Handle(TColgp_HArray1OfPnt) points =
        new TColgp_HArray1OfPnt(1, static_cast<int>(end - i) + (closed ? 0 : 1));
    for (int k = points->Lower(); k <= points->Upper(); ++k) {
      points->SetValue(k, point(corner(i + static_cast<std::size_t>(k) - 1).at));
    }
    GeomAPI_Interpolate through(points, closed, kOnePoint);
    through.Perform();
    if (!through.IsDone()) throw std::runtime_error("there is no smooth curve through its outline");
    return through.Curve();
  }

  TopoDS_Wire closed_curve() const {
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve(0, corners_.size(), true)).Edge())
        .Wire();
  }

  double z_;
  std::vector<PlanCorner> corners_;
  BRepBuilderAPI_MakeWire wire_;
};

}  // namespace

TopoDS_Wire wire_of(const SolidLoop& loop, double z, double millimetres) {
  if (loop.radius == 0) return WireMaker(loop, z, millimetres).make();
  const Vec2d centre = millimetres * loop.centre;
  const gp_Circ circle(gp_Ax2(gp_Pnt(centre.x, centre.y, z), gp_Dir(0, 0, 1)),
                       millimetres * loop.radius);
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge()).Wire();
}

}  // namespace cognate::app
