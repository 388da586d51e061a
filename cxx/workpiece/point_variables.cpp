#include "workpiece/point_variables.hpp"
#include "workpiece/point_place.hpp"
#include <algorithm>

namespace burnish {
namespace {

/// Least von Mises stress, to divide by.
constexpr double NO_STRESS = 1e-300;

} // namespace

template <int Dim> PointVariables<Dim>::PointVariables(const MaterialLaw<Dim>& law) {
  const InternalVariables<Dim>& internal = law.internal_variables();
  for (std::size_t k = 0; k < internal.list().size(); ++k) {
    const InternalVariable& variable = internal.list()[k];
    if (variable.kind != TensorKind::SCALAR || variable.symbol.empty()) continue;
    m_names.push_back(variable.symbol);
    m_offsets.push_back(internal.offset(static_cast<int>(k)));
  }
  m_names.insert(m_names.end(), {"seq", "sm"});
  for (const char* component : PointTraits<Dim>::stress_names)
    m_names.push_back(std::string("s") + component);
  m_names.insert(m_names.end(), {"s1", "s3"});
  for (const char* axis : PointTraits<Dim>::axis_names) m_names.push_back(axis);
}

template <int Dim>
typename PointVariables<Dim>::Sample
PointVariables<Dim>::sample(const Workpiece<Dim>& body, const WorkpieceState<Dim>& state, int point) const {
  const PointState<Dim> at = point_state(state, point);
  Sample sample{at.stress, {}, point_place(body.discretization(), point, state)};
  for (const int offset : m_offsets) sample.scalars.push_back(at.internal[offset]);
  return sample;
}

template <int Dim>
void PointVariables<Dim>::values(const Sample& start, const Sample& end, double f, double* result) const {
  const Stress<Dim> t = (1 - f) * start.stress + f * end.stress;
  const Vector<Dim> x = (1 - f) * start.x + f * end.x;
  const auto [largest, smallest] = extreme_principals(t);
  for (std::size_t k = 0; k < start.scalars.size(); ++k)
    *result++ = (1 - f) * start.scalars[k] + f * end.scalars[k];
  *result++ = std::max(equivalent<Dim>(deviator<Dim>(t)), NO_STRESS);
  *result++ = mean<Dim>(t);
  result = std::copy(t.begin(), t.end(), result);
  *result++ = largest;
  *result++ = smallest;
  std::copy(x.begin(), x.end(), result);
}

template class PointVariables<2>;
template class PointVariables<3>;

} // namespace burnish
