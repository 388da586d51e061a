#pragma once
// The contact surface and the tools of a run as .vtp files for ParaView, written whole (whole_file.hpp).
// @throws FileError
#include "geometry/surface_mesh.hpp"
#include "run/contact_run.hpp"
#include <string>

namespace burnish {

/// The contact surface in the reference configuration: in the plane an edge, in space a triangle between neighboring candidates each, four
/// of them for a quadratic facet, on which the tractions are linear. At the candidates: displacement, state
/// (NodeState), tool (number, -1 none), gap, pressure, traction_tangential, nodal_pressure, nodal_traction as in SurfaceReport,
/// and traction, the vector of what the tool exerts on the body [stress].
template <int Dim> void save_surface(const ContactRun<Dim>& run, const std::string& path);

/// Nodes with a component of displacement that is given, at their reference places: fixed, 1 or 0 for x and y, in space z.
template <int Dim> void save_supports(const ContactRun<Dim>& run, const std::string& path);
/// Outline of a tool of the setup where it is, as a picture of the workpiece needs it. @param u displacement; empty: none
std::vector<Vector<2>> tool_outline(const ContactSetup<2>& setup, const Eigen::VectorXd& u, int tool);
/// Surface of a tool of the setup where it is, near the workpiece. @param u displacement; empty: none
SurfaceMesh tool_surface(const ContactSetup<3>& setup, const Eigen::VectorXd& u, int tool);
/// All tools where they are, with their numbers as `tool`: in the plane an outline each, see tool_outline; in space triangles, see
/// tool_surface, with the origin of the tool's frame as `origin` [length]. Their
/// displacement is zero, so that a filter that adds it moves the workpiece only. @param u displacement; empty: none
template <int Dim>
void save_tools(const ContactSetup<Dim>& setup, const Eigen::VectorXd& u, const std::string& path);

} // namespace burnish
