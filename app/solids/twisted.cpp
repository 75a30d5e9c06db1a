#include "app/solids/twisted.hpp"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Trsf.hxx>
#include <stdexcept>
#include <vector>

#include "app/solids/wire.hpp"

namespace cognate::app {
namespace {

// The polynomials of a span have the values and two derivatives of the screw at both its ends. They
// leave the unit circle by no more than 0.1⁶/46080 = 2e-11 where a span turns by 0.1.
constexpr int kDegree = 5, kKnots = 3;
constexpr double kSpanTurn = 0.1;

/// A pole of the screw: the section at its height, turned and stretched by a complex number.
struct ScrewPole {
  Vec2d factor{};
  double height = 0;
};

/// e^{iφ} and the height over the parameter from 0 to the number of spans, φ from `begin` on by the
/// twist.
class Screw {
 public:
  Screw(double low, double high, double begin, double twist)
      : low_(low),
        high_(high),
        begin_(begin),
        spans_(std::max(1, static_cast<int>(std::ceil(std::abs(twist) / kSpanTurn)))),
        turn_(twist / spans_) {
    for (int span = 0; span < spans_; ++span) add_span(span);
  }

  int spans() const { return spans_; }
  const std::vector<ScrewPole>& poles() const { return poles_; }

 private:
  static Vec2d unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

  /// Those of Bézier's points that are poles; in place of two at a knot what they make together.
  void add_span(int span) {
    const Vec2d begin = unit(begin_ + span * turn_), end = unit(begin_ + (span + 1) * turn_);
    const double first = turn_ / kDegree, second = turn_ * turn_ / (kDegree * (kDegree - 1));
    const Vec2d third = end * Vec2d{1 - second, -2 * first}, fourth = end * Vec2d{1, -first};
    if (span == 0) {
      add(span, 0, begin);
      add(span, 1, begin * Vec2d{1, first});
    }
    add(span, 2, begin * Vec2d{1 - second, 2 * first});
    add(span, 3, third);
    if (span + 1 < spans_) {
      add(span, kDegree, 2.0 * fourth - third);
    } else {
      add(span, 4, fourth);
      add(span, kDegree, end);
    }
  }

  void add(int span, int fifths, const Vec2d& factor) {
    const double share = (span + 1.0 * fifths / kDegree) / spans_;
    poles_.push_back({factor, std::lerp(low_, high_, share)});
  }

  double low_, high_, begin_;
  int spans_;
  double turn_;
  std::vector<ScrewPole> poles_;
};

Handle(Geom_BSplineCurve) spline_of(const TopoDS_Edge& edge) {
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  return GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(curve, first, last));
}

/// What the curve sweeps along the screw: its poles times those of the screw, which is exact.
Handle(Geom_BSplineSurface) swept(const Geom_BSplineCurve& curve, const Screw& screw) {
  const int rows = curve.NbPoles(), columns = static_cast<int>(screw.poles().size());
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  TColStd_Array2OfReal weights(1, rows, 1, columns);
  for (int i = 1; i <= rows; ++i) {
    const gp_Pnt pole = curve.Pole(i);
    for (int k = 1; k <= columns; ++k) {
      const auto& [factor, height] = screw.poles()[static_cast<std::size_t>(k) - 1];
      const Vec2d at = factor * Vec2d{pole.X(), pole.Y()};
      poles.SetValue(i, k, {at.x, at.y, height});
      weights.SetValue(i, k, curve.Weight(i));
    }
  }
  TColStd_Array1OfReal knots(0, screw.spans());
  TColStd_Array1OfInteger times(0, screw.spans());
  for (int k = 0; k <= screw.spans(); ++k) {
    knots.SetValue(k, k);
    times.SetValue(k, k == 0 || k == screw.spans() ? kDegree + 1 : kKnots);
  }
  return new Geom_BSplineSurface(poles, weights, curve.Knots(), knots, curve.Multiplicities(),
                                 times, curve.Degree(), kDegree);
}

/// So many that a chord of the screw at the outline leaves it by an eighth of the tolerance: the
/// mesh then needs hardly a node within a slice, where a whole face takes ten times as many facets.
int slices_of(const SolidPrism& prism, double millimetres, std::optional<double> facets) {
  constexpr double kMost = 128;
  if (!facets) return 1;
  double radius = 0;
  for (const PlanCorner& corner : prism.loop.corners) radius = std::max(radius, norm(corner.at));
  const double turn = std::sqrt(*facets / (millimetres * radius));
  return static_cast<int>(std::clamp(std::ceil(std::abs(prism.twist) / turn), 1.0, kMost));
}

gp_Trsf screwed(double height, double twist) {
  gp_Trsf turn, move;
  turn.SetRotation(gp::OZ(), twist);
  move.SetTranslation(gp_Vec(0, 0, height));
  return move * turn;
}

}  // namespace

TopoDS_Shape twisted_prism(const SolidPrism& prism, double millimetres,
                           std::optional<double> facets) {
  const double low = millimetres * prism.low, high = millimetres * prism.high;
  const TopoDS_Wire wire = wire_of(prism.loop, low, millimetres);
  const int slices = slices_of(prism, millimetres, facets);
  const double height = (high - low) / slices, turn = prism.twist / slices;
  BRepBuilderAPI_Sewing sewing(kOnePoint);
  const TopoDS_Face lower = BRepBuilderAPI_MakeFace(wire, true).Face();
  sewing.Add(lower);
  sewing.Add(BRepBuilderAPI_Transform(lower, screwed(high - low, prism.twist), true).Shape());
  for (TopExp_Explorer edges(wire, TopAbs_EDGE); edges.More(); edges.Next()) {
    const auto curve = spline_of(TopoDS::Edge(edges.Current()));
    for (int k = 0; k < slices; ++k) {
      const Screw screw(low + k * height, low + (k + 1) * height, k * turn, turn);
      sewing.Add(BRepBuilderAPI_MakeFace(swept(*curve, screw), kOnePoint).Face());
    }
  }
  sewing.Perform();
  if (sewing.NbFreeEdges() > 0 || sewing.SewedShape().ShapeType() != TopAbs_SHELL) {
    throw std::runtime_error("its twisted faces do not close");
  }
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape())).Solid();
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

}  // namespace cognate::app
