#pragma once
// The workpiece as a .vtu file for ParaView: the reference mesh with displacement and stress at its nodes.
#include "output/file_units.hpp"
#include "workpiece/workpiece.hpp"
#include <string>

namespace burnish {

/// Writes the file whole (whole_file.hpp). In the plane elements become triangles between neighboring nodes, four of each quadratic one; in
/// space they are VTK's linear or quadratic tetrahedra. At the nodes: displacement, stress as a tensor (xx yy zz xy yz xz) and
/// by components (those of Stress, "stress_xx"), the same for cauchy, stress_eq, stress_error; plastic_strain_eq and backstress of a law that has them,
/// integrity where damage is defined. Fields of the quadrature points are those of nodal_average. In the field data, where the units are
/// known: meters_per_length, pascals_per_stress.
/// @throws FileError
template <int Dim>
void save_fields(const Workpiece<Dim>& body, const std::string& path, const FileUnits& units = {});
/// The displacement alone, of a body of whose stress nothing is known. @param u num_dofs, Dim for every node [length]
template <int Dim>
void save_displacement(const Discretization<Dim>& mesh, const Eigen::VectorXd& u, const std::string& path);

} // namespace burnish
