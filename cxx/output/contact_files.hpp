#pragma once
// The contact surface and the tools of a run as .vtp files for ParaView, written whole (whole_file.hpp).
// @throws FileError
#include "run/contact_run.hpp"
#include <string>

namespace burnish {

/// The contact surface, an edge between neighboring candidates each, in the reference configuration: displacement, state
/// (NodeState), tool (number, -1 none), gap, pressure, traction_tangential, nodal_pressure, nodal_traction as in SurfaceReport,
/// and traction, the vector of what the tool exerts on the body [stress].
void save_surface(const ContactRun<2>& run, const std::string& path);

/// Nodes with a component of displacement that is given, at their reference places: fixed, 1 or 0 for x and y.
void save_supports(const ContactRun<2>& run, const std::string& path);
/// Outline of a tool of the setup where it is, as a picture of the workpiece needs it. @param u displacement; empty: none
std::vector<Vector<2>> tool_outline(const ContactSetup<2>& setup, const Eigen::VectorXd& u, int tool);
/// Outlines of all tools, see tool_outline, a line each, with their numbers as `tool`. They are where they are: their
/// displacement is zero, so that a filter that adds it moves the workpiece only.
void save_tools(const ContactSetup<2>& setup, const Eigen::VectorXd& u, const std::string& path);

} // namespace burnish
