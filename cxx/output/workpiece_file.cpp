#include "output/workpiece_file.hpp"
#include "base/whole_file.hpp"
#include "output/vtk_file.hpp"
#include "workpiece/nodal_average.hpp"
#include "workpiece/point_fields.hpp"
#include "workpiece/stress_error.hpp"

namespace burnish {
namespace {

constexpr int VTK_TRIANGLE = 5;
using Field = Eigen::VectorXd;            // over the nodes
using Names = std::array<const char*, 4>; // of the components xx, yy, zz, xy
constexpr Names STRESS = {"stress_xx", "stress_yy", "stress_zz", "stress_xy"};
constexpr Names CAUCHY = {"cauchy_xx", "cauchy_yy", "cauchy_zz", "cauchy_xy"};
constexpr Names BACKSTRESS = {"backstress_xx", "backstress_yy", "backstress_zz", "backstress_xy"};

/// Node-major numbers of three components from those of two: the plane of the picture.
std::vector<double> in_space(const double* xy, int nodes) {
  std::vector<double> xyz(3 * static_cast<std::size_t>(nodes), 0.);
  for (int a = 0; a < nodes; ++a)
    for (int i = 0; i < 2; ++i) xyz[3 * a + i] = xy[2 * a + i];
  return xyz;
}
std::vector<double> list_of(const Field& field) { return {field.data(), field.data() + field.size()}; }

/// Local nodes of the triangles that an element is cut into. A mid-edge node lies opposite its vertex.
const std::vector<std::array<int, 3>>& cut(int nodes_per_element) {
  static const std::vector<std::array<int, 3>> whole = {{0, 1, 2}},
                                               parts = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}, {3, 4, 5}};
  return nodes_per_element == 3 ? whole : parts;
}

void write_cells(const Discretization<2>& mesh, VtkFile& file) {
  std::vector<std::int64_t> connectivity, offsets;
  for (int e = 0; e < mesh.num_elements; ++e)
    for (const auto& triangle : cut(mesh.nodes_per_element)) {
      for (const int a : triangle) connectivity.push_back(mesh.element(e)[a]);
      offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    }
  file.open("Cells");
  file.array("connectivity", connectivity);
  file.array("offsets", offsets);
  file.array("types", std::vector<std::uint8_t>(offsets.size(), VTK_TRIANGLE));
  file.close();
}

// In the order of ParaView's symmetric tensors, and component by component.
void write_tensor(const char* name, const Names& names, const std::array<Field, 4>& part, VtkFile& file) {
  const auto nodes = static_cast<std::size_t>(part[0].size());
  std::vector<double> tensor(6 * nodes, 0.);
  for (std::size_t a = 0; a < nodes; ++a)
    for (int i = 0; i < 4; ++i) tensor[6 * a + i] = part[i][static_cast<Eigen::Index>(a)];
  file.array(name, 6, tensor, {"XX", "YY", "ZZ", "XY", "YZ", "XZ"});
  for (int i = 0; i < 4; ++i) file.array(names[i], 1, list_of(part[i]));
}

std::array<Field, 4> stress_at_nodes(const NodalFit<2>& at_nodes, const std::vector<double>& stress) {
  std::array<Field, 4> part;
  const Eigen::Map<const Eigen::Matrix<double, 4, Eigen::Dynamic>> points(
      stress.data(), 4, static_cast<Eigen::Index>(stress.size() / 4));
  for (int i = 0; i < 4; ++i) part[i] = at_nodes(Field(points.row(i)));
  return part;
}

void write_points(const Workpiece<2>& body, VtkFile& file) {
  const Discretization<2>& mesh = body.discretization();
  const NodalFit<2> at_nodes(mesh);
  const std::vector<double> stress = stress_field(body);
  file.array("displacement", 3, in_space(body.state().displacement.data(), mesh.num_nodes));
  write_tensor("stress", STRESS, stress_at_nodes(at_nodes, stress), file);
  write_tensor("cauchy", CAUCHY, stress_at_nodes(at_nodes, cauchy_field(body)), file);
  file.array("stress_eq", 1, list_of(at_nodes(stress_eq_field(body))));
  file.array("plastic_strain_eq", 1, list_of(at_nodes(internal_field(body, "plastic_strain_eq"))));
  file.array("stress_error", 1, list_of(at_nodes(stress_error(mesh, at_nodes, stress).point)));
  if (body.law().internal_variables().names().find("backstress") != std::string::npos) {
    std::array<Field, 4> part;
    for (int i = 0; i < 4; ++i) part[i] = at_nodes(internal_field(body, "backstress", i));
    write_tensor("backstress", BACKSTRESS, part, file);
  }
  if (body.state().tracks_integrity()) file.array("integrity", 1, list_of(at_nodes(integrity_field(body))));
}

// @param fields writes the arrays at the nodes; @param names attributes of the element that holds them
template <class Fields>
void write_nodes(const Discretization<2>& mesh, const char* names, Fields fields, const std::string& path) {
  VtkFile file("UnstructuredGrid");
  file.open("Piece", "NumberOfPoints=\"" + std::to_string(mesh.num_nodes) + "\" NumberOfCells=\"" +
                         std::to_string(mesh.num_elements * cut(mesh.nodes_per_element).size()) + "\"");
  file.open("PointData", names);
  fields(file);
  file.close();
  file.open("Points");
  file.array("Points", 3, in_space(mesh.X.data(), mesh.num_nodes));
  file.close();
  write_cells(mesh, file);
  write_whole(path, file.text());
}

} // namespace

void save_fields(const Workpiece<2>& body, const std::string& path) {
  write_nodes(
      body.discretization(), "Scalars=\"stress_eq\" Vectors=\"displacement\" Tensors=\"stress\"",
      [&](VtkFile& file) { write_points(body, file); }, path);
}

void save_displacement(const Discretization<2>& mesh, const Eigen::VectorXd& u, const std::string& path) {
  write_nodes(
      mesh, "Vectors=\"displacement\"",
      [&](VtkFile& file) { file.array("displacement", 3, in_space(u.data(), mesh.num_nodes)); }, path);
}

} // namespace burnish
