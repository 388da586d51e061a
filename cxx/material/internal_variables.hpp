#pragma once
// The internal variables of a law by name, and where their components are among the numbers of a point.
#include "material/point_traits.hpp"
#include <string>
#include <vector>

namespace burnish {

enum class TensorKind {
  SCALAR,
  SYMMETRIC, ///< components in the order of Stress<Dim>; a law that keeps one turns it with the body (a back stress)
};

struct InternalVariable {
  std::string name;   ///< as in files: plastic_strain_eq
  std::string symbol; ///< as in formulas of scripts: ep; empty: formulas do not see it
  std::string unit;   ///< "-", "stress"
  TensorKind kind = TensorKind::SCALAR;
  double initial = 0; ///< of every component, in the undeformed body
};

template <int Dim> int num_components(TensorKind kind) {
  return kind == TensorKind::SCALAR ? 1 : num_stress<Dim>;
}

/// Variables in order, their components one after another.
template <int Dim> class InternalVariables {
public:
  InternalVariables() = default;
  /// @throws std::invalid_argument if a name is empty or occurs twice
  explicit InternalVariables(std::vector<InternalVariable> list);
  const std::vector<InternalVariable>& list() const { return m_list; }
  int size() const { return m_size; } ///< numbers per point
  /// Place of the first component of variable k of the list.
  int offset(int k) const { return m_offset[k]; }
  /// Which variable bears the name; -1: none.
  int find(const std::string& name) const;
  std::string names() const; ///< all of them, for messages; "none"
  /// All components of a point in the undeformed body.
  std::vector<double> initial() const;

private:
  std::vector<InternalVariable> m_list;
  std::vector<int> m_offset;
  int m_size = 0;
};

} // namespace burnish
