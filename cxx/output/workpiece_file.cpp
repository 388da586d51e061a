#include "output/workpiece_file.hpp"
#include "base/whole_file.hpp"
#include "mesh/simplex.hpp"
#include "output/vtk_file.hpp"
#include "workpiece/nodal_average.hpp"
#include "workpiece/point_fields.hpp"
#include "workpiece/stress_error.hpp"

namespace burnish {
namespace {

using Field = Eigen::VectorXd; // over the nodes
template <int Dim> using Components = std::array<Field, num_stress<Dim>>;

/// Node-major numbers of three components; in the plane z = 0.
template <int Dim> std::vector<double> in_space(const double* x, int nodes) {
  std::vector<double> xyz(3 * static_cast<std::size_t>(nodes), 0.);
  for (int a = 0; a < nodes; ++a)
    for (int i = 0; i < Dim; ++i) xyz[3 * a + i] = x[Dim * a + i];
  return xyz;
}
std::vector<double> list_of(const Field& field) { return {field.data(), field.data() + field.size()}; }

/// Cells that an element becomes, all of one type of VTK, and their nodes as local nodes of the element.
template <int Dim> struct ElementCells {
  std::uint8_t type;
  std::vector<std::vector<int>> nodes;
};
template <int Dim> ElementCells<Dim> cells_of(int nodes_per_element);
template <> ElementCells<2> cells_of(int nodes_per_element) {
  constexpr std::uint8_t triangle = 5;
  ElementCells<2> cells{triangle, {}};
  for (const auto& part : linear_parts<2>(nodes_per_element))
    cells.nodes.emplace_back(part.begin(), part.end());
  return cells;
}
/// VTK has mid-edge nodes of tetrahedra on 01, 12, 20, 03, 13, 23; SimplexEdges<3> on 01, 02, 03, 12, 13, 23.
template <> ElementCells<3> cells_of(int nodes_per_element) {
  constexpr std::uint8_t tetrahedron = 10, quadratic_tetrahedron = 24;
  if (nodes_per_element == 4) return {tetrahedron, {{0, 1, 2, 3}}};
  return {quadratic_tetrahedron, {{0, 1, 2, 3, 4, 7, 5, 6, 8, 9}}};
}

template <int Dim> void write_cells(const Discretization<Dim>& mesh, VtkFile& file) {
  const ElementCells<Dim> cells = cells_of<Dim>(mesh.nodes_per_element);
  std::vector<std::int64_t> connectivity, offsets;
  for (int e = 0; e < mesh.num_elements; ++e)
    for (const auto& nodes : cells.nodes) {
      for (const int a : nodes) connectivity.push_back(mesh.element(e)[a]);
      offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    }
  file.open("Cells");
  file.array("connectivity", connectivity);
  file.array("offsets", offsets);
  file.array("types", std::vector<std::uint8_t>(offsets.size(), cells.type));
  file.close();
}

// In the order of ParaView's symmetric tensors, which is that of Stress, and component by component.
template <int Dim> void write_tensor(const std::string& name, const Components<Dim>& part, VtkFile& file) {
  const auto nodes = static_cast<std::size_t>(part[0].size());
  std::vector<double> tensor(6 * nodes, 0.);
  for (std::size_t a = 0; a < nodes; ++a)
    for (int i = 0; i < num_stress<Dim>; ++i) tensor[6 * a + i] = part[i][static_cast<Eigen::Index>(a)];
  file.array(name, 6, tensor, {"XX", "YY", "ZZ", "XY", "YZ", "XZ"});
  for (int i = 0; i < num_stress<Dim>; ++i)
    file.array(name + "_" + PointTraits<Dim>::stress_names[i], 1, list_of(part[i]));
}

template <int Dim>
Components<Dim> stress_at_nodes(const NodalFit<Dim>& at_nodes, const std::vector<double>& stress) {
  Components<Dim> part;
  const Eigen::Map<const Eigen::Matrix<double, num_stress<Dim>, Eigen::Dynamic>> points(
      stress.data(), num_stress<Dim>, static_cast<Eigen::Index>(stress.size() / num_stress<Dim>));
  for (int i = 0; i < num_stress<Dim>; ++i) part[i] = at_nodes(Field(points.row(i)));
  return part;
}

template <int Dim> bool has(const Workpiece<Dim>& body, const char* variable) {
  return body.law().internal_variables().find(variable) >= 0;
}

template <int Dim> void write_points(const Workpiece<Dim>& body, VtkFile& file) {
  const Discretization<Dim>& mesh = body.discretization();
  const NodalFit<Dim> at_nodes(mesh);
  const std::vector<double> stress = stress_field(body);
  file.array("displacement", 3, in_space<Dim>(body.state().displacement.data(), mesh.num_nodes));
  write_tensor<Dim>("stress", stress_at_nodes(at_nodes, stress), file);
  write_tensor<Dim>("cauchy", stress_at_nodes(at_nodes, cauchy_field(body)), file);
  file.array("stress_eq", 1, list_of(at_nodes(stress_eq_field(body))));
  if (has(body, "plastic_strain_eq"))
    file.array("plastic_strain_eq", 1, list_of(at_nodes(internal_field(body, "plastic_strain_eq"))));
  file.array("stress_error", 1, list_of(at_nodes(stress_error(mesh, at_nodes, stress).point)));
  if (has(body, "backstress")) {
    Components<Dim> part;
    for (int i = 0; i < num_stress<Dim>; ++i) part[i] = at_nodes(internal_field(body, "backstress", i));
    write_tensor<Dim>("backstress", part, file);
  }
  if (body.state().tracks_integrity()) file.array("integrity", 1, list_of(at_nodes(integrity_field(body))));
}

void write_units(const FileUnits& units, VtkFile& file) {
  if (units.length.empty()) return;
  file.open("FieldData");
  file.field("meters_per_length", units.meters);
  file.field("pascals_per_stress", units.pascals);
  file.close();
}

// @param fields writes the arrays at the nodes; @param names attributes of the element that holds them
template <int Dim, class Fields>
void write_nodes(const Discretization<Dim>& mesh, const char* names, Fields fields, const std::string& path,
                 const FileUnits& units = {}) {
  const std::size_t cells = mesh.num_elements * cells_of<Dim>(mesh.nodes_per_element).nodes.size();
  VtkFile file("UnstructuredGrid");
  write_units(units, file);
  file.open("Piece", "NumberOfPoints=\"" + std::to_string(mesh.num_nodes) + "\" NumberOfCells=\"" +
                         std::to_string(cells) + "\"");
  file.open("PointData", names);
  fields(file);
  file.close();
  file.open("Points");
  file.array("Points", 3, in_space<Dim>(mesh.X.data(), mesh.num_nodes));
  file.close();
  write_cells(mesh, file);
  write_whole(path, file.text());
}

} // namespace

template <int Dim>
void save_fields(const Workpiece<Dim>& body, const std::string& path, const FileUnits& units) {
  write_nodes(
      body.discretization(), "Scalars=\"stress_eq\" Vectors=\"displacement\" Tensors=\"stress\"",
      [&](VtkFile& file) { write_points(body, file); }, path, units);
}

template <int Dim>
void save_displacement(const Discretization<Dim>& mesh, const Eigen::VectorXd& u, const std::string& path) {
  write_nodes(
      mesh, "Vectors=\"displacement\"",
      [&](VtkFile& file) { file.array("displacement", 3, in_space<Dim>(u.data(), mesh.num_nodes)); }, path);
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template void save_fields<Dim>(const Workpiece<Dim>&, const std::string&, const FileUnits&);               \
  template void save_displacement<Dim>(const Discretization<Dim>&, const Eigen::VectorXd&,                   \
                                       const std::string&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
