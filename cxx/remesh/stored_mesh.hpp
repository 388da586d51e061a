#pragma once
// The mesh of a run that has gone on on a new one: in its checkpoint, and from there in place of the mesh that the resumed
// script begins with (ALGORITHMS.md 19.5).
#include "remesh/remesh.hpp"
#include <string>

namespace burnish {

/// Plain data.
template <int Dim> struct StoredMesh {
  Mesh<Dim> mesh;
  std::vector<char> fixed;           ///< num_dofs flags: displacement is given
  std::vector<Remeshing> remeshings; ///< of the run so far
};

template <int Dim> std::string packed(const StoredMesh<Dim>& stored);
/// @throws std::invalid_argument if the bytes are not those of a mesh of this dimension
template <int Dim> StoredMesh<Dim> unpacked_mesh(const std::string& bytes);

/// Body and contact of a run on that mesh, undeformed: the state of the checkpoint is still to be put in.
/// @param body, contact as the script begins the run, on its own mesh
/// @throws std::invalid_argument as setup_on
template <int Dim>
RemeshedRun<Dim> on_stored_mesh(const Workpiece<Dim>& body, const ContactRun<Dim>& contact,
                                const StoredMesh<Dim>& stored);

} // namespace burnish
