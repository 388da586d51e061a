#include "checks/deformation_check.hpp"
#include "checks/known_law.hpp"
#include "material/j2/law.hpp"
#include "mesh/simplex.hpp"
#include <algorithm>
#include <cmath>
#include <sstream>

namespace burnish {
namespace {

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

template <int Dim> bool with_jaumann_rate(const Workpiece<Dim>& workpiece) {
  if constexpr (Dim == 2)
    if (const auto* law = dynamic_cast<const J2Law<2>*>(&workpiece.law()))
      return law->parameters().rate == CorotationalRate::JAUMANN;
  return false;
}

template <int Dim> Vector<Dim> middle(const AcceptedStep<Dim>& step, int e) {
  Vector<Dim> x = Vector<Dim>::Zero();
  for (int v = 0; v <= Dim; ++v) x += step.body.position(step.u, step.mesh.element(e)[v]) / (Dim + 1);
  return x;
}

} // namespace

template <int Dim>
void DeformationCheck<Dim>::look_at_strain(const AcceptedStep<Dim>& step, const CheckOptions& options,
                                           CheckState& state, FindingList& findings) const {
  if (!known_law(step.workpiece)) return;
  Eigen::Index worst = 0;
  const double strain = plastic_strains(step.workpiece).maxCoeff(&worst);
  state.largest("plastic strain", strain);
  if (!with_jaumann_rate(step.workpiece) || !(strain > options.plastic_strain)) return;
  const bool far = strain > options.plastic_strain_far;
  Finding* finding =
      findings.report("plastic strain", "", far ? Severity::UNTRUSTED : Severity::WARNING, strain, step.t);
  if (!finding) return;
  finding->value = strain;
  finding->bound = far ? options.plastic_strain_far : options.plastic_strain;
  const Vector<Dim> x = step.point(static_cast<int>(worst));
  finding->place = step.place_of(x);
  std::ostringstream text;
  text << "plastic strain " << strain << step.at(x)
       << " is beyond the range of the law: with the Jaumann rate stresses swing from "
       << options.plastic_strain << " on; take rate=\"logarithmic\"";
  finding->text = text.str();
}

template <int Dim>
void DeformationCheck<Dim>::look_at_elements(const AcceptedStep<Dim>& step, const CheckOptions& options,
                                             CheckState& state, FindingList& findings) {
  const auto now = [&](int node) { return step.body.position(step.u, node); };
  const auto before = [&](int node) { return step.mesh.node(node); };
  double smallest = std::numeric_limits<double>::infinity();
  int worst = -1, vertex = 0;
  constexpr double near = 2;
  const int nodes = step.mesh.nodes_per_element;
  for (int e = 0; e < step.mesh.num_elements; ++e)
    for (int v = 0; v <= (nodes == Dim + 1 ? 0 : Dim); ++v) {
      const double ratio = jacobian_at<Dim>(nodes, step.mesh.element(e), v, now).determinant() /
                           jacobian_at<Dim>(nodes, step.mesh.element(e), v, before).determinant();
      if (ratio >= smallest) continue;
      smallest = ratio;
      worst = e;
      vertex = v;
    }
  state.smallest("determinant", smallest);
  state.distorted = smallest < near * options.determinant;
  if (!(smallest < options.determinant)) return;
  Severity severity = Severity::WARNING;
  if (smallest < options.determinant_low) severity = Severity::UNTRUSTED;
  if (smallest <= 0) severity = Severity::STOP;
  Finding* finding = findings.report("distortion", "", severity, -smallest, step.t);
  if (!finding) return;
  finding->value = smallest;
  finding->bound = severity == Severity::WARNING ? options.determinant
                                                 : (severity == Severity::STOP ? 0 : options.determinant_low);
  const Vector<Dim> x = now(step.mesh.element(worst)[vertex]);
  finding->place = step.place_of(x);
  std::ostringstream text;
  text << "an element " << (smallest <= 0 ? "is inverted" : "is distorted") << ": its Jacobian is "
       << smallest << " times that of the undeformed one (element " << worst << step.at(x)
       << "): refine or end the run earlier";
  finding->text = text.str();
  if (severity == Severity::STOP) state.stop = finding->text;
}

template <int Dim>
void DeformationCheck<Dim>::look_at_shapes(const AcceptedStep<Dim>& step, const CheckOptions& options,
                                           CheckState& state, FindingList& findings) {
  constexpr double fallen = 0.25; // a mesh may be slender from the start
  const auto now = [&](int node) { return step.body.position(step.u, node); };
  const auto before = [&](int node) { return step.mesh.node(node); };
  if (m_quality.empty())
    for (int e = 0; e < step.mesh.num_elements; ++e)
      m_quality.push_back(quality<Dim>(step.mesh.element(e), before));
  double smallest = 1;
  int worst = -1;
  for (int e = 0; e < step.mesh.num_elements; ++e) {
    const double q = quality<Dim>(step.mesh.element(e), now);
    if (q >= smallest || q > fallen * m_quality[e]) continue;
    smallest = q;
    worst = e;
  }
  state.smallest("shape", smallest);
  if (worst < 0 || !(smallest < options.quality)) return;
  Finding* finding = findings.report("distortion", "shape", Severity::WARNING, -smallest, step.t);
  if (!finding) return;
  finding->value = smallest;
  finding->bound = options.quality;
  const Vector<Dim> x = middle(step, worst);
  finding->place = step.place_of(x);
  std::ostringstream text;
  text << "an element has become slender: quality " << smallest << ", 1 is equilateral (element " << worst
       << step.at(x) << ")";
  finding->text = text.str();
}

template <int Dim>
void DeformationCheck<Dim>::look(const AcceptedStep<Dim>& step, const CheckOptions& options,
                                 CheckState& state, FindingList& findings) {
  const bool all = step.last || state.steps % options.seldom == 0;
  look_at_strain(step, options, state, findings);
  if (all || state.distorted) look_at_elements(step, options, state, findings);
  if (all) look_at_shapes(step, options, state, findings);
}

template class DeformationCheck<2>;
template class DeformationCheck<3>;

} // namespace burnish
