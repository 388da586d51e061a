#include "geometry/exact_curve.hpp"
#include "base/error.hpp"
#include "geometry/cad_edge.hpp"
#include <GeomAdaptor_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>

namespace burnish {

namespace {

constexpr const char* WHERE = "CadCurve";
constexpr double ENDLESS = 1e50; // the parameter of an endless line is 2e100
constexpr double ASIDE = 1e-14;  // of a span

Vector<3> vector_of(const gp_XYZ& x) { return {x.X(), x.Y(), x.Z()}; }

} // namespace

struct ExactCurve::Kept {
  Handle(Geom_Curve) curve;
  Handle(Geom_BSplineCurve) spline; ///< the same if it is one, not periodic; else null
  struct Span {
    int knot;     ///< of the spline, where it begins
    double shift; ///< periods between u and the parameter of the spline
  };
  std::vector<Span> spans;

  void find_spans(const std::vector<double>& knots);
};

// (Geom_BSplineCurve::Segment is of no use for this: where an end is close to a knot it bends the last span.)
void ExactCurve::Kept::find_spans(const std::vector<double>& knots) {
  const double first = spline->FirstParameter(), period = spline->LastParameter() - first;
  const bool periodic = spline->IsPeriodic();
  if (periodic) {
    spline = Handle(Geom_BSplineCurve)::DownCast(spline->Copy());
    spline->SetNotPeriodic();
  }
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double middle = (knots[i] + knots[i + 1]) / 2;
    const double shift = periodic ? period * std::floor((middle - first) / period) : 0;
    int begin = 0, end = 0;
    spline->LocateU(middle - shift, 0, begin, end);
    spans.push_back({begin, shift});
  }
}

ExactCurve::ExactCurve(const CadEdge& edge, const std::string& name) {
  if (edge.curve.IsNull()) fail(WHERE, name + " " + edge.missing);
  if (!(edge.begin < edge.end && std::abs(edge.begin) < ENDLESS && std::abs(edge.end) < ENDLESS))
    fail(WHERE, name + " has no range of its parameter: its points are not finite or fall together");
  auto kept = std::make_shared<Kept>();
  try {
    const GeomAdaptor_Curve adaptor(edge.curve, edge.begin, edge.end);
    TColStd_Array1OfReal knots(1, adaptor.NbIntervals(GeomAbs_CN) + 1);
    adaptor.Intervals(knots, GeomAbs_CN);
    m_knots.assign(knots.begin(), knots.end());
    kept->curve = edge.curve;
    kept->spline = Handle(Geom_BSplineCurve)::DownCast(edge.curve);
    if (!kept->spline.IsNull()) kept->find_spans(m_knots);
  } catch (const Standard_Failure& failure) {
    fail(WHERE, name + " cannot be evaluated: " + failure.GetMessageString());
  }
  m_kept = kept;
}

ExactCurve::Value ExactCurve::evaluate(double u, bool before) const {
  const auto inner = m_knots.begin() + 1, last = m_knots.end() - 1;
  const auto end = before ? std::lower_bound(inner, last, u) : std::upper_bound(inner, last, u);
  gp_Pnt x;
  gp_Vec first, second;
  if (!m_kept->spline.IsNull()) {
    const Kept::Span& span = m_kept->spans[static_cast<std::size_t>(end - inner)];
    m_kept->spline->LocalD2(u - span.shift, span.knot, span.knot + 1, x, first, second);
  } else {
    // at and beyond the ends of a span its own derivatives
    const double begin = *(end - 1), aside = m_knots.size() > 2 ? ASIDE * (*end - begin) : 0;
    const double inside = aside > 0 ? std::clamp(u, begin + aside, *end - aside) : u;
    m_kept->curve->D2(inside, x, first, second);
    x.Translate((u - inside) * first);
  }
  return {vector_of(x.XYZ()), vector_of(first.XYZ()), vector_of(second.XYZ())};
}

} // namespace burnish
