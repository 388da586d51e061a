#pragma once
// Curves of a CAD file, whatever its format.
#include "cad/gmsh_library.hpp"
#include "cad/occ/cad_edge.hpp"
#include <vector>

namespace burnish {

/// One .geo, .step, .stp or .brep file, read.
class CadFile {
public:
  /// @param numbers  values for names of a .geo file, taken where the file says DefineConstant
  /// @param seconds  of computing that a .geo file may take
  /// @throws std::invalid_argument with the file and what is wrong: missing, empty, of another kind, damaged, syntax
  /// error, no curves; a number whose name the file does not have, or overwrites
  CadFile(std::string path, const GeoNumbers& numbers, double seconds);

  const std::string& path() const { return m_path; }
  /// Tags of all curves as gmsh numbers them, ascending.
  const std::vector<int>& curves() const { return m_curves; }
  /// 0 point, 2 surface, 3 volume of that tag? (to tell a wrong tag)
  bool has(int dimension, int tag) const;
  const CadEdge& edge(int tag) const { return m_model.edges.at(tag); }

private:
  std::string m_path;
  CadModel m_model;
  std::vector<int> m_curves;
};

} // namespace burnish
