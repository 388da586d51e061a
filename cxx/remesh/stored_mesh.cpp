#include "remesh/stored_mesh.hpp"
#include "base/packed.hpp"

namespace burnish {

template <class Archive, int Dim> void serialize(Archive& archive, Facet<Dim>& value) {
  BURNISH_MEMBERS(value, vertex, middle, element, label);
}
template <class Archive, int Dim> void serialize(Archive& archive, Mesh<Dim>& value) {
  BURNISH_MEMBERS(value, num_nodes, nodes_per_element, num_elements, axisymmetric, X, connectivity, facets);
}
template <class Archive> void serialize(Archive& archive, MeshState& value) {
  BURNISH_MEMBERS(value, nodes, shape, volume, elastic_energy, force);
}
template <class Archive> void serialize(Archive& archive, Remeshing& value) {
  BURNISH_MEMBERS(value, t, before, after, iterations, settled, meshed);
}
template <class Archive, int Dim> void serialize(Archive& archive, StoredMesh<Dim>& value) {
  BURNISH_MEMBERS(value, mesh, fixed, remeshings);
}

template <int Dim> std::string packed(const StoredMesh<Dim>& stored) { return bytes_of<Dim>(stored); }
template <int Dim> StoredMesh<Dim> unpacked_mesh(const std::string& bytes) {
  return value_of_bytes<Dim, StoredMesh<Dim>>(bytes, "unpacked_mesh", "mesh");
}

namespace {

Discretization<2> discretization_of(const Mesh<2>& mesh) { return triangles(mesh); }
Discretization<3> discretization_of(const Mesh<3>& mesh) { return tetrahedra(mesh); }

} // namespace

template <int Dim>
RemeshedRun<Dim> on_stored_mesh(const Workpiece<Dim>& body, const ContactRun<Dim>& contact,
                                const StoredMesh<Dim>& stored) {
  RemeshedRun<Dim> result = run_on<Dim>(body, contact, discretization_of(stored.mesh), stored.fixed);
  if (body.state_old().tracks_integrity()) result.workpiece->track_integrity();
  result.origin.assign(static_cast<std::size_t>(result.workpiece->discretization().num_points()), 0);
  return result;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template std::string packed<Dim>(const StoredMesh<Dim>&);                                                  \
  template StoredMesh<Dim> unpacked_mesh<Dim>(const std::string&);                                           \
  template RemeshedRun<Dim> on_stored_mesh<Dim>(const Workpiece<Dim>&, const ContactRun<Dim>&,               \
                                                const StoredMesh<Dim>&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
