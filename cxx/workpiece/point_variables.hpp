#pragma once
// What a user-defined formula may ask of a quadrature point, by name, along the way through a step.
#include "workpiece/workpiece.hpp"

namespace burnish {

/// Names: the scalar internal variables of the law by their symbols (ep accumulated plastic strain [-]); of
/// the Kirchhoff stress [stress]: seq von Mises, sm mean, sxx syy szz sxy (in space syz szx) components, s1
/// and s3 largest and smallest principal stress; x, y (in space z) present position [length]. seq is at least
/// 1e-300, so that sm/seq is 0 without stress.
template <int Dim> class PointVariables {
public:
  explicit PointVariables(const MaterialLaw<Dim>& law);
  const std::vector<std::string>& names() const { return m_names; }

  /// What is linear inside a step.
  struct Sample {
    Stress<Dim> stress;
    std::vector<double> scalars;
    Vector<Dim> x;
  };
  /// @param state either state of the workpiece
  Sample sample(const Workpiece<Dim>& body, const WorkpieceState<Dim>& state, int point) const;
  /// Values at the fraction f between two samples, in the order of names().
  void values(const Sample& start, const Sample& end, double f, double* result) const;

private:
  std::vector<int> m_offsets; // of the scalars among the internal variables of a point
  std::vector<std::string> m_names;
};

} // namespace burnish
