#pragma once
// FreeFEM's meshes as bytes, and back with the same numbering and places to the last bit.
#include "base/error.hpp"
#include "types.hpp"

namespace burnish {

inline Serialize serialized_mesh(const ::Mesh& mesh) { return mesh.serialize(); }
inline Serialize serialized_mesh(const ::Mesh3& mesh) {
  return mesh.meshS ? mesh.serialize_withBorderMesh() : mesh.serialize();
}
inline ::Mesh* mesh_of_serialized(Serialize& bytes, const ::Mesh*) {
  auto mesh = std::make_unique<::Mesh>(bytes);
  if (!mesh->quadtree) mesh->MakeQuadTree();
  return mesh.release();
}
inline ::Mesh3* mesh_of_serialized(Serialize& bytes, const ::Mesh3*) {
  auto mesh = bytes.havebordermesh() ? std::make_unique<::Mesh3>(bytes, 1) : std::make_unique<::Mesh3>(bytes);
  if (!mesh->gtree) mesh->BuildGTree();
  return mesh.release();
}

template <class FreefemMesh> std::string mesh_bytes(const FreefemMesh& mesh) {
  Serialize bytes = serialized_mesh(mesh);
  return {static_cast<char*>(bytes), bytes.size()};
}
/// @returns a new mesh, which is its owner's
template <class FreefemMesh> const FreefemMesh* mesh_of_bytes(const std::string& bytes) {
  Serialize copy(bytes.size(), "mesh of a checkpoint");
  std::memcpy(static_cast<char*>(copy), bytes.data(), bytes.size());
  return mesh_of_serialized(copy, static_cast<const FreefemMesh*>(nullptr));
}

/// FreeFEM's mesh of a run; the one of the other dimension is null.
struct RunMesh {
  const ::Mesh* plane = nullptr;
  const ::Mesh3* space = nullptr;
  const ::Mesh* of(const ::Mesh*) const { return plane; }
  const ::Mesh3* of(const ::Mesh3*) const { return space; }
};

} // namespace burnish
