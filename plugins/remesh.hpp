#pragma once
// Contact and material of a script on another mesh.
#include "remesh/remesh.hpp"
#include "types.hpp"

namespace burnish {

/// Contact and material go over to what is on another mesh. Runs that refer to the contact end.
/// @param mesh FreeFEM's, of the same numbering
template <int Dim>
void take_mesh(ContactOf<Dim>& contact, MaterialOf<Dim>& material, RemeshedRun<Dim> there,
               std::shared_ptr<const typename Freefem<Dim>::Mesh> mesh);

} // namespace burnish
