#pragma once
// Curves of a CAD file through the gmsh library, and nothing of gmsh elsewhere.
#include "base/types.hpp"
#include <map>
#include <string>
#include <vector>

namespace burnish {

/// Range of a curve's own parameter and what may be asked of it.
struct CadEdge {
  int tag;
  std::string type; ///< as gmsh calls it: Line, Circle, Nurb, BSpline, ...
  double begin, end;
  bool exact_derivative; ///< OpenCASCADE; gmsh's built-in kernel differentiates numerically (error 1e-8)
};

/// "R=10e-3; H=2e-3" (separated by ; or ,) as names and values.
/// @throws std::invalid_argument for anything else, and for a name given twice
std::map<std::string, double> parse_numbers(const std::string& where, const std::string& text);

/// One .geo, .step, .stp or .brep file, open as a model of its own in gmsh while this object lives. gmsh
/// keeps one state for the whole process: its current model and options, the locale and the streams are put
/// back after every call; it installs no signal handlers, and stays initialized to the end of the process.
/// What one .geo file defines (names, ONELAB parameters) is not seen by the next one.
class CadFile {
public:
  /// @param numbers  values for names of a .geo file, taken where the file says DefineConstant
  /// @throws std::invalid_argument with the file and what gmsh says: missing, empty, of another kind, syntax
  /// error; a number whose name the file does not have, or overwrites
  CadFile(std::string path, const std::map<std::string, double>& numbers);
  ~CadFile();
  CadFile(const CadFile&) = delete;
  CadFile& operator=(const CadFile&) = delete;

  const std::string& path() const { return m_path; }
  /// Tags of all curves, ascending.
  const std::vector<int>& curves() const { return m_curves; }
  /// 0 point, 2 surface, 3 volume of that tag? (to tell a wrong tag)
  bool has(int dimension, int tag) const;
  CadEdge edge(int tag) const;
  /// Points, or derivatives by u, at parameters u: 3 by n [length of the file], [length of the file per u].
  Eigen::Matrix3Xd value(int tag, const std::vector<double>& u) const;
  Eigen::Matrix3Xd derivative(int tag, const std::vector<double>& u) const;

private:
  std::string m_path, m_model;
  std::vector<int> m_curves, m_exact; ///< m_exact: curves of OpenCASCADE
};

} // namespace burnish
