#pragma once
// The workpiece as a .vtu file for ParaView: the reference mesh with displacement and stress at its nodes.
#include "workpiece/workpiece.hpp"
#include <string>

namespace burnish {

/// Writes the file whole (whole_file.hpp). Elements become triangles between neighboring nodes, four of each quadratic one. At the nodes:
/// displacement, stress as a tensor (xx yy zz xy yz xz) and by components, stress_eq, plastic_strain_eq,
/// stress_error; backstress of a law that has one, integrity where damage is defined. Fields of the quadrature points are
/// those of nodal_average.
/// @throws FileError
void save_fields(const Workpiece<2>& body, const std::string& path);
/// The displacement alone, of a body of whose stress nothing is known. @param u x and y of every node [length]
void save_displacement(const Discretization<2>& mesh, const Eigen::VectorXd& u, const std::string& path);

} // namespace burnish
