#include "output/contact_files.hpp"
#include "base/whole_file.hpp"
#include "contact/surface_report.hpp"
#include "kinematics/window_outline.hpp"
#include "output/vtk_file.hpp"

namespace burnish {
namespace {

using Numbers = std::vector<double>;

std::string piece(std::size_t points, std::size_t lines, std::size_t vertices = 0) {
  return "NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfVerts=\"" + std::to_string(vertices) +
         "\" NumberOfLines=\"" + std::to_string(lines) + "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\"";
}

Numbers numbers(const Eigen::VectorXd& v) { return {v.data(), v.data() + v.size()}; }

/// Edges between candidates, as indices of candidates; a quadratic edge has two halves.
std::vector<std::vector<int>> edges_of(const ContactRun<2>& run) {
  std::map<int, int> index;
  const std::vector<int>& candidates = run.setup().candidates();
  for (std::size_t i = 0; i < candidates.size(); ++i) index[candidates[i]] = static_cast<int>(i);
  std::vector<std::vector<int>> edges;
  for (const auto& facet : run.setup().surface()) {
    std::vector<int> nodes = {facet.vertex[0], facet.vertex[1]};
    if (facet.middle[0] >= 0) nodes.insert(nodes.begin() + 1, facet.middle[0]);
    for (std::size_t k = 1; k < nodes.size(); ++k)
      if (index.count(nodes[k - 1]) && index.count(nodes[k]))
        edges.push_back({index[nodes[k - 1]], index[nodes[k]]});
  }
  return edges;
}

/// Pressure and tangential traction along the normal and tangent of the tool, of free nodes the nearest one [stress].
Numbers traction_vectors(const ContactRun<2>& run, const SurfaceReport<2>& report) {
  const auto& state = run.accepted().contact;
  const auto& model = run.setup().model();
  const auto poses = model.poses(state.q);
  Numbers vectors(3 * state.nodes.size(), 0.);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    if (report.pressure[k] == 0 && report.traction_tangential.col(k).isZero(0)) continue;
    const auto& node = state.nodes[i];
    NearestTool<2> at{node.tool, {node.place}};
    if (!in_contact(node.state)) {
      const auto x = run.setup().body().position(run.accepted().u, model.candidates[i]);
      at = nearest_tool(model, poses, x, node, static_cast<int>(i));
      if (at.tool < 0) continue;
    }
    const auto p = model.tools[at.tool]->point(poses[at.tool], at.foot.place);
    const Vector<2> traction = report.pressure[k] * p.n + p.E * report.traction_tangential.col(k);
    for (int a = 0; a < 2; ++a) vectors[3 * i + a] = traction[a];
  }
  return vectors;
}

void write_surface_data(const ContactRun<2>& run, VtkFile& file) {
  const auto& state = run.accepted();
  const auto report = surface_report(run.setup().model(), run.setup().body(), state.contact,
                                     run.setup().surface(), state.u, state.R);
  const std::vector<int>& candidates = run.setup().candidates();
  Numbers displacement(3 * candidates.size(), 0.);
  std::vector<std::int64_t> states, tools;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (int a = 0; a < 2; ++a) displacement[3 * i + a] = state.u[2 * candidates[i] + a];
    states.push_back(static_cast<std::int64_t>(state.contact.nodes[i].state));
    tools.push_back(state.contact.nodes[i].tool);
  }
  file.array("displacement", 3, displacement);
  file.array("state", states);
  file.array("tool", tools);
  file.array("gap", 1, numbers(report.gap));
  file.array("pressure", 1, numbers(report.pressure));
  file.array("traction_tangential", 1, numbers(report.traction_tangential.row(0)));
  file.array("nodal_pressure", 1, numbers(report.nodal_pressure));
  file.array("nodal_traction", 1, numbers(report.nodal_traction.row(0)));
  file.array("traction", 3, traction_vectors(run, report));
}

} // namespace

void save_surface(const ContactRun<2>& run, const std::string& path) {
  const std::vector<int>& candidates = run.setup().candidates();
  const auto edges = edges_of(run);
  Numbers places(3 * candidates.size(), 0.);
  for (std::size_t i = 0; i < candidates.size(); ++i)
    for (int a = 0; a < 2; ++a) places[3 * i + a] = run.setup().mesh().X[2 * candidates[i] + a];
  VtkFile file("PolyData");
  file.open("Piece", piece(candidates.size(), edges.size()));
  file.open("PointData", "Scalars=\"pressure\" Vectors=\"displacement\"");
  write_surface_data(run, file);
  file.close();
  file.open("Points");
  file.array("Points", 3, places);
  file.close();
  file.lines(edges);
  write_whole(path, file.text());
}

void save_supports(const ContactRun<2>& run, const std::string& path) {
  const std::vector<char>& fixed = run.setup().body().fixed;
  Numbers places, components;
  std::vector<std::vector<int>> points;
  for (int a = 0; a < run.setup().mesh().num_nodes; ++a) {
    if (!fixed[2 * a] && !fixed[2 * a + 1]) continue;
    const Vector<2> X = run.setup().mesh().node(a);
    places.insert(places.end(), {X[0], X[1], 0.});
    components.insert(components.end(), {fixed[2 * a] ? 1. : 0., fixed[2 * a + 1] ? 1. : 0.});
    points.push_back({static_cast<int>(points.size())});
  }
  VtkFile file("PolyData");
  file.open("Piece", piece(points.size(), 0, points.size()));
  file.open("PointData");
  file.array("fixed", 2, components, {"X", "Y"});
  file.close();
  file.open("Points");
  file.array("Points", 3, places);
  file.close();
  file.lines(points, "Verts");
  write_whole(path, file.text());
}

std::vector<Vector<2>> tool_outline(const ContactSetup<2>& setup, const Eigen::VectorXd& u, int tool) {
  Eigen::VectorXd places = Eigen::Map<const Eigen::VectorXd>(setup.mesh().X.data(), setup.mesh().num_dofs());
  if (u.size() > 0) places += u;
  DrivenTool<2>& driven = *setup.tools()[tool];
  return window_outline(driven.tool(), driven.q(), picture_window<2>(places));
}

void save_tools(const ContactSetup<2>& setup, const Eigen::VectorXd& u, const std::string& path) {
  std::vector<std::vector<int>> lines;
  std::vector<std::int64_t> numbers;
  Numbers places;
  for (std::size_t i = 0; i < setup.tools().size(); ++i) {
    lines.emplace_back();
    for (const Vector<2>& x : tool_outline(setup, u, static_cast<int>(i))) {
      lines.back().push_back(static_cast<int>(places.size() / 3));
      places.insert(places.end(), {x[0], x[1], 0.});
    }
    numbers.push_back(static_cast<std::int64_t>(i));
  }
  VtkFile file("PolyData");
  file.open("Piece", piece(places.size() / 3, lines.size()));
  file.open("PointData", "Vectors=\"displacement\"");
  file.array("displacement", 3, Numbers(places.size(), 0.));
  file.close();
  file.open("CellData");
  file.array("tool", numbers);
  file.close();
  file.open("Points");
  file.array("Points", 3, places);
  file.close();
  file.lines(lines);
  write_whole(path, file.text());
}

} // namespace burnish
