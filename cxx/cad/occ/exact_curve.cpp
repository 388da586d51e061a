#include "cad/occ/exact_curve.hpp"
#include "base/error.hpp"
#include "cad/occ/cad_edge.hpp"
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>

namespace burnish {

namespace {

constexpr const char* EXACT_CURVE = "CadCurve";
constexpr double ENDLESS = 1e50; // the parameter of an endless line is 2e100
constexpr double CLOSE = 1e-10;  // of the range: a knot there is an end (STEP files have 12 digits or so)
constexpr double ASIDE = 1e-14;  // of a span

Vector<3> vector_of(const gp_XYZ& x) { return {x.X(), x.Y(), x.Z()}; }

/// The spline that a curve is, or is at a distance from; null if there is none.
Handle(Geom_BSplineCurve) spline_below(Handle(Geom_Curve) curve) {
  for (;;) {
    if (const auto* offset = dynamic_cast<const Geom_OffsetCurve*>(curve.get()))
      curve = offset->BasisCurve();
    else if (const auto* trimmed = dynamic_cast<const Geom_TrimmedCurve*>(curve.get()))
      curve = trimmed->BasisCurve();
    else
      return Handle(Geom_BSplineCurve)::DownCast(curve);
  }
}

void check_knots(const Handle(Geom_BSplineCurve) & spline, const std::string& name) {
  for (int i = 1; !spline.IsNull() && i <= spline->NbKnots(); ++i)
    if (!(std::abs(spline->Knot(i)) < ENDLESS && (i == 1 || spline->Knot(i) > spline->Knot(i - 1))))
      fail(EXACT_CURVE, name + " has knots that are not finite or do not ascend");
}

/// Ends and all knots between them, ascending. (Adaptors know of no knots of splines of degree 5 and more: what
/// they call CN is four derivatives.)
std::vector<double> knots_between(const Handle(Geom_BSplineCurve) & spline, double begin, double end) {
  std::vector<double> knots{begin};
  const double close = CLOSE * (end - begin);
  const bool periodic = !spline.IsNull() && spline->IsPeriodic();
  const double first = spline.IsNull() ? 0 : spline->FirstParameter(),
               period = periodic ? spline->Period() : 0;
  double shift = periodic ? period * std::floor((begin - first) / period) : 0;
  for (int i = 1; !spline.IsNull() && i <= spline->NbKnots(); ++i) {
    const double knot = spline->Knot(i) + shift;
    if (knot >= end - close) break;
    if (knot > knots.back() + close) knots.push_back(knot);
    if (periodic && i == spline->NbKnots()) {
      i = 1; // the same as the last one
      shift += period;
    }
  }
  knots.push_back(end);
  return knots;
}

/// @param spline  with all its poles and knots, not periodic
std::vector<BezierSpan> spans_of(const Geom_BSplineCurve& spline, const std::vector<double>& knots,
                                 double period) {
  std::vector<Vector<3>> poles;
  std::vector<double> weights;
  for (int i = 1; i <= spline.NbPoles(); ++i) {
    poles.push_back(vector_of(spline.Pole(i).XYZ()));
    weights.push_back(spline.Weight(i));
  }
  const auto& sequence = spline.KnotSequence();
  const std::vector<double> repeated(sequence.begin(), sequence.end());
  const double first = spline.FirstParameter();
  std::vector<BezierSpan> spans;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double middle = (knots[i] + knots[i + 1]) / 2;
    const double shift = period > 0 ? period * std::floor((middle - first) / period) : 0;
    const auto next = std::upper_bound(repeated.begin(), repeated.end(), middle - shift);
    spans.emplace_back(poles, weights, repeated, static_cast<std::size_t>(next - repeated.begin() - 1),
                       shift);
  }
  return spans;
}

} // namespace

struct ExactCurve::Kept {
  std::vector<BezierSpan> spans; ///< of a spline
  Handle(Geom_Curve) curve;      ///< of everything else
};

ExactCurve::ExactCurve(const CadEdge& edge, const std::string& name) {
  if (edge.curve.IsNull()) fail(EXACT_CURVE, name + " " + edge.missing);
  if (!(edge.begin < edge.end && std::abs(edge.begin) < ENDLESS && std::abs(edge.end) < ENDLESS))
    fail(EXACT_CURVE, name + " has no range of its parameter: its points are not finite or fall together");
  auto kept = std::make_shared<Kept>();
  try {
    kept->curve = edge.curve;
    if (kept->curve->IsKind(STANDARD_TYPE(Geom_BezierCurve)))
      kept->curve = GeomConvert::CurveToBSplineCurve(kept->curve);
    check_knots(spline_below(kept->curve), name);
    m_knots = knots_between(spline_below(kept->curve), edge.begin, edge.end);
    if (kept->curve->IsKind(STANDARD_TYPE(Geom_BSplineCurve))) {
      const auto spline = Handle(Geom_BSplineCurve)::DownCast(kept->curve->Copy());
      const double period = spline->IsPeriodic() ? spline->Period() : 0;
      // (not Segment: where an end of the range is close to a knot it bends the last span)
      if (period > 0) spline->SetNotPeriodic();
      kept->spans = spans_of(*spline, m_knots, period);
    }
  } catch (const Standard_Failure& failure) {
    fail(EXACT_CURVE, name + " cannot be evaluated: " + failure.GetMessageString());
  }
  m_kept = kept;
}

CurveValue ExactCurve::evaluate(double u, bool before) const {
  const auto inner = m_knots.begin() + 1, last = m_knots.end() - 1;
  const auto end = before ? std::lower_bound(inner, last, u) : std::upper_bound(inner, last, u);
  if (!m_kept->spans.empty()) return m_kept->spans[static_cast<std::size_t>(end - inner)].at(u);
  // at and beyond the ends of a span its own derivatives
  const double begin = *(end - 1), aside = m_knots.size() > 2 ? ASIDE * (*end - begin) : 0;
  const double inside = aside > 0 ? std::clamp(u, begin + aside, *end - aside) : u;
  gp_Pnt x;
  gp_Vec first, second;
  m_kept->curve->D2(inside, x, first, second);
  x.Translate((u - inside) * first);
  return {vector_of(x.XYZ()), vector_of(first.XYZ()), vector_of(second.XYZ())};
}

} // namespace burnish
