// Distortion of the elements (ALGORITHMS.md 16.4).
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"
#include "mesh/simplex.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

// Jacobian of an element over that of the undeformed one: warning below, untrusted below
constexpr double DETERMINANT = 0.3, LOW = 0.1;
constexpr double QUALITY =
    0.1; // shape of an element, 1: equilateral: warning below, if it has fallen to a quarter

// Columns: edges of an element from vertex v, tangents at v; quadratic elements bend: the derivative there is
// 4 x_mid - 3 x_v - x_w towards vertex w.
template <int Dim, class Place> Tensor<Dim> jacobian_at(int nodes, const int* node, int v, const Place& x) {
  Tensor<Dim> J;
  int column = 0;
  for (int w = 0; w <= Dim; ++w) {
    if (w == v) continue;
    if (nodes == Dim + 1) {
      J.col(column++) = x(node[w]) - x(node[v]);
      continue;
    }
    const auto& ends = SimplexEdges<Dim>::ends;
    for (int e = 0; e < num_edges<Dim>; ++e)
      if ((ends[e][0] == v && ends[e][1] == w) || (ends[e][0] == w && ends[e][1] == v))
        J.col(column++) = 4 * x(node[Dim + 1 + e]) - 3 * x(node[v]) - x(node[w]);
  }
  return J;
}

// 1: equilateral, 0: flat.
template <int Dim, class Place> double quality(const int* node, const Place& x) {
  Tensor<Dim> J;
  double squares = 0;
  for (int v = 0; v <= Dim; ++v)
    for (int w = 0; w < v; ++w) squares += (x(node[v]) - x(node[w])).squaredNorm();
  for (int w = 1; w <= Dim; ++w) J.col(w - 1) = x(node[w]) - x(node[0]);
  const double volume = std::abs(J.determinant());
  if (Dim == 2) return 2 * std::sqrt(3.) * volume / squares;
  return 6 * std::sqrt(2.) * volume / std::pow(squares / 6, 1.5) / 6;
}

template <int Dim> Vector<Dim> middle(const AcceptedStep<Dim>& step, int e) {
  Vector<Dim> x = Vector<Dim>::Zero();
  for (int v = 0; v <= Dim; ++v) x += step.body().position(step.u, step.mesh().element(e)[v]) / (Dim + 1);
  return x;
}

template <int Dim> class DistortionCheck final : public ObserverOf<DistortionCheck<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_distorted, m_quality)
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override {
    if (step.tenth() || m_distorted) look_at_elements(step, findings);
    if (step.tenth()) look_at_shapes(step, findings);
  }

private:
  void look_at_elements(const AcceptedStep<Dim>& step, FindingList& findings);
  void look_at_shapes(const AcceptedStep<Dim>& step, FindingList& findings);

  bool m_distorted = false;      // an element is near its bound: all are looked at in every step
  std::vector<double> m_quality; // of the undeformed elements
};

template <int Dim>
void DistortionCheck<Dim>::look_at_elements(const AcceptedStep<Dim>& step, FindingList& findings) {
  const auto now = [&](int node) { return step.body().position(step.u, node); };
  const auto before = [&](int node) { return step.mesh().node(node); };
  double smallest = std::numeric_limits<double>::infinity();
  int worst = -1, vertex = 0;
  constexpr double near = 2;
  const int nodes = step.mesh().nodes_per_element;
  for (int e = 0; e < step.mesh().num_elements; ++e)
    for (int v = 0; v <= (nodes == Dim + 1 ? 0 : Dim); ++v) {
      const double ratio = jacobian_at<Dim>(nodes, step.mesh().element(e), v, now).determinant() /
                           jacobian_at<Dim>(nodes, step.mesh().element(e), v, before).determinant();
      if (ratio >= smallest) continue;
      smallest = ratio;
      worst = e;
      vertex = v;
    }
  findings.smallest("determinant", smallest);
  m_distorted = smallest < near * DETERMINANT;
  if (!(smallest < DETERMINANT)) return;
  Severity severity = Severity::WARNING;
  if (smallest < LOW) severity = Severity::UNTRUSTED;
  if (smallest <= 0) severity = Severity::STOP;
  Finding* finding = findings.report("distortion", "", severity, -smallest, step.t);
  if (!finding) return;
  finding->value = smallest;
  finding->bound = severity == Severity::WARNING ? DETERMINANT : (severity == Severity::STOP ? 0 : LOW);
  const Vector<Dim> x = now(step.mesh().element(worst)[vertex]);
  finding->place = step.place_of(x);
  finding->text = sentence("an element ", (smallest <= 0 ? "is inverted" : "is distorted"),
                           ": its Jacobian is ", smallest, " times that of the undeformed one (element ",
                           worst, step.at(x), "): refine or end the run earlier");
}

template <int Dim>
void DistortionCheck<Dim>::look_at_shapes(const AcceptedStep<Dim>& step, FindingList& findings) {
  constexpr double fallen = 0.25; // a mesh may be slender from the start
  const auto now = [&](int node) { return step.body().position(step.u, node); };
  const auto before = [&](int node) { return step.mesh().node(node); };
  if (m_quality.empty())
    for (int e = 0; e < step.mesh().num_elements; ++e)
      m_quality.push_back(quality<Dim>(step.mesh().element(e), before));
  double smallest = 1;
  int worst = -1;
  for (int e = 0; e < step.mesh().num_elements; ++e) {
    const double q = quality<Dim>(step.mesh().element(e), now);
    if (q >= smallest || q > fallen * m_quality[e]) continue;
    smallest = q;
    worst = e;
  }
  findings.smallest("shape", smallest);
  if (worst < 0 || !(smallest < QUALITY)) return;
  Finding* finding = findings.report("distortion", "shape", Severity::WARNING, -smallest, step.t);
  if (!finding) return;
  finding->value = smallest;
  finding->bound = QUALITY;
  const Vector<Dim> x = middle(step, worst);
  finding->place = step.place_of(x);
  finding->text = sentence("an element has become slender: quality ", smallest,
                           ", 1 is equilateral (element ", worst, step.at(x), ")");
}

} // namespace

BURNISH_OBSERVER(distortion_check, DistortionCheck)

} // namespace burnish
