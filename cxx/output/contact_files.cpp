#include "output/contact_files.hpp"
#include "base/whole_file.hpp"
#include "contact/surface_report.hpp"
#include "kinematics/surface_mesh.hpp"
#include "kinematics/window_outline.hpp"
#include "mesh/simplex.hpp"
#include "output/vtk_file.hpp"

namespace burnish {
namespace {

using Numbers = std::vector<double>;

using CellList = std::vector<std::vector<int>>;

/// Element of VTK that holds the facets of the space.
template <int Dim> constexpr const char* FACETS = Dim == 2 ? "Lines" : "Polys";

std::string piece(std::size_t points, const char* cells, std::size_t number) {
  std::string attributes = "NumberOfPoints=\"" + std::to_string(points) + "\"";
  for (const std::string kind : {"Verts", "Lines", "Strips", "Polys"})
    attributes += " NumberOf" + kind + "=\"" + std::to_string(kind == cells ? number : 0) + "\"";
  return attributes;
}

Numbers numbers(const Eigen::MatrixXd& m) { return {m.data(), m.data() + m.size()}; } // column by column

/// Appends a place or vector, in the plane with z = 0.
template <int Dim> void append(const Vector<Dim>& x, Numbers& places) {
  for (int i = 0; i < 3; ++i) places.push_back(i < Dim ? x[i] : 0);
}

/// Facets between candidates, as indices of candidates; a quadratic one has its linear parts.
template <int Dim> CellList facets_of(const ContactRun<Dim>& run) {
  const std::vector<int> index = candidate_of_node(run.setup().candidates(), run.setup().mesh().num_nodes);
  CellList facets;
  for (const Facet<Dim>& facet : run.setup().surface()) {
    const std::vector<int> nodes = nodes_of(facet);
    for (const auto& part : linear_parts<Dim - 1>(static_cast<int>(nodes.size()))) {
      std::vector<int> cell;
      for (const int a : part)
        if (index[nodes[a]] >= 0) cell.push_back(index[nodes[a]]);
      if (cell.size() == part.size()) facets.push_back(std::move(cell));
    }
  }
  return facets;
}

/// Pressure and tangential traction along the normal and tangents of the tool, of free nodes the nearest one [stress].
template <int Dim> Numbers traction_vectors(const ContactRun<Dim>& run, const SurfaceReport<Dim>& report) {
  const auto& state = run.accepted().contact;
  const auto& model = run.setup().model();
  const auto poses = model.poses(state.q);
  Numbers vectors;
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const auto& node = state.nodes[i];
    NearestTool<Dim> at{node.tool, {node.place}};
    const bool none = report.pressure[k] == 0 && report.traction_tangential.col(k).isZero(0);
    if (!none && !in_contact(node.state)) {
      const auto x = run.setup().body().position(run.accepted().u, model.candidates[i]);
      at = nearest_tool(model, poses, x, node, static_cast<int>(i));
    }
    Vector<Dim> traction = Vector<Dim>::Zero();
    if (!none && at.tool >= 0) {
      const auto p = model.tools[at.tool]->point(poses[at.tool], at.foot.place);
      traction = report.pressure[k] * p.n + shear_vector<Dim>(p.E, report.traction_tangential.col(k));
    }
    append(traction, vectors);
  }
  return vectors;
}

template <int Dim> void write_surface_data(const ContactRun<Dim>& run, VtkFile& file) {
  constexpr int shear = SHEAR_COMPONENTS<Dim>;
  const auto& state = run.accepted();
  const auto report = surface_report(run.setup().model(), run.setup().body(), state.contact,
                                     run.setup().surface(), state.u, state.R);
  const std::vector<int>& candidates = run.setup().candidates();
  Numbers displacement;
  std::vector<std::int64_t> states, tools;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    append<Dim>(state.u.template segment<Dim>(Dim * candidates[i]), displacement);
    states.push_back(static_cast<std::int64_t>(state.contact.nodes[i].state));
    tools.push_back(state.contact.nodes[i].tool);
  }
  file.array("displacement", 3, displacement);
  file.array("state", states);
  file.array("tool", tools);
  file.array("gap", 1, numbers(report.gap));
  file.array("pressure", 1, numbers(report.pressure));
  file.array("traction_tangential", shear, numbers(report.traction_tangential));
  file.array("nodal_pressure", 1, numbers(report.nodal_pressure));
  file.array("nodal_traction", shear, numbers(report.nodal_traction));
  file.array("traction", 3, traction_vectors(run, report));
}

void write_places(const Numbers& places, VtkFile& file) {
  file.open("Points");
  file.array("Points", 3, places);
  file.close();
}

/// All tools of a setup.
struct DrawnTools {
  Numbers places;
  CellList cells;
  std::vector<std::int64_t> tool; // of each cell
  Numbers origin;                 // in space, of each cell
};

template <int Dim> Eigen::VectorXd present_places(const ContactSetup<Dim>& setup, const Eigen::VectorXd& u) {
  Eigen::VectorXd places = Eigen::Map<const Eigen::VectorXd>(setup.mesh().X.data(), setup.mesh().num_dofs());
  if (u.size() > 0) places += u;
  return places;
}

DrawnTools drawn_tools(const ContactSetup<2>& setup, const Eigen::VectorXd& u) {
  DrawnTools drawn;
  for (std::size_t i = 0; i < setup.tools().size(); ++i) {
    drawn.cells.emplace_back();
    for (const Vector<2>& x : tool_outline(setup, u, static_cast<int>(i))) {
      drawn.cells.back().push_back(static_cast<int>(drawn.places.size() / 3));
      append(x, drawn.places);
    }
    drawn.tool.push_back(static_cast<std::int64_t>(i));
  }
  return drawn;
}

DrawnTools drawn_tools(const ContactSetup<3>& setup, const Eigen::VectorXd& u) {
  DrawnTools drawn;
  for (std::size_t i = 0; i < setup.tools().size(); ++i) {
    DrivenTool<3>& driven = *setup.tools()[i];
    const Vector<3> origin = driven.tool().coordinates().pose(driven.q()).origin;
    const SurfaceMesh mesh = tool_surface(setup, u, static_cast<int>(i));
    const int first = static_cast<int>(drawn.places.size() / 3);
    for (const Vector<3>& x : mesh.points) append(x, drawn.places);
    for (const auto& t : mesh.triangles) {
      drawn.cells.push_back({first + t[0], first + t[1], first + t[2]});
      drawn.tool.push_back(static_cast<std::int64_t>(i));
      append(origin, drawn.origin);
    }
  }
  return drawn;
}

} // namespace

template <int Dim> void save_surface(const ContactRun<Dim>& run, const std::string& path) {
  const CellList facets = facets_of(run);
  Numbers places;
  for (const int node : run.setup().candidates()) append(run.setup().mesh().node(node), places);
  VtkFile file("PolyData");
  file.open("Piece", piece(places.size() / 3, FACETS<Dim>, facets.size()));
  file.open("PointData", "Scalars=\"pressure\" Vectors=\"displacement\"");
  write_surface_data(run, file);
  file.close();
  write_places(places, file);
  file.lines(facets, FACETS<Dim>);
  write_whole(path, file.text());
}

template <int Dim> void save_supports(const ContactRun<Dim>& run, const std::string& path) {
  const std::vector<char>& fixed = run.setup().body().fixed;
  Numbers places, components;
  CellList points;
  for (int a = 0; a < run.setup().mesh().num_nodes; ++a) {
    const auto first = fixed.begin() + Dim * a;
    if (std::none_of(first, first + Dim, [](char held) { return held != 0; })) continue;
    append(run.setup().mesh().node(a), places);
    for (int i = 0; i < Dim; ++i) components.push_back(first[i] ? 1 : 0);
    points.push_back({static_cast<int>(points.size())});
  }
  std::vector<std::string> axes{"X", "Y", "Z"};
  axes.resize(Dim);
  VtkFile file("PolyData");
  file.open("Piece", piece(points.size(), "Verts", points.size()));
  file.open("PointData");
  file.array("fixed", Dim, components, axes);
  file.close();
  write_places(places, file);
  file.lines(points, "Verts");
  write_whole(path, file.text());
}

std::vector<Vector<2>> tool_outline(const ContactSetup<2>& setup, const Eigen::VectorXd& u, int tool) {
  DrivenTool<2>& driven = *setup.tools()[tool];
  return window_outline(driven.tool(), driven.q(), picture_window<2>(present_places(setup, u)));
}

SurfaceMesh tool_surface(const ContactSetup<3>& setup, const Eigen::VectorXd& u, int tool) {
  DrivenTool<3>& driven = *setup.tools()[tool];
  const PictureWindow<3> window = picture_window<3>(present_places(setup, u));
  return surface_mesh(driven.tool(), driven.q(), Eigen::AlignedBox3d(window.low, window.high));
}

template <int Dim>
void save_tools(const ContactSetup<Dim>& setup, const Eigen::VectorXd& u, const std::string& path) {
  const DrawnTools drawn = drawn_tools(setup, u);
  VtkFile file("PolyData");
  file.open("Piece", piece(drawn.places.size() / 3, FACETS<Dim>, drawn.cells.size()));
  file.open("PointData", "Vectors=\"displacement\"");
  file.array("displacement", 3, Numbers(drawn.places.size(), 0.));
  file.close();
  file.open("CellData");
  file.array("tool", drawn.tool);
  if (Dim == 3) file.array("origin", 3, drawn.origin);
  file.close();
  write_places(drawn.places, file);
  file.lines(drawn.cells, FACETS<Dim>);
  write_whole(path, file.text());
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template void save_surface<Dim>(const ContactRun<Dim>&, const std::string&);                               \
  template void save_supports<Dim>(const ContactRun<Dim>&, const std::string&);                              \
  template void save_tools<Dim>(const ContactSetup<Dim>&, const Eigen::VectorXd&, const std::string&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
