#include "checkpoint/stage.hpp"
#include "checkpoint/identity.hpp"
#include "remesh/stored_mesh.hpp"
#include "run/run_archive.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

std::vector<IdentityPart> parts_named(const char* name, const Checkpoint& checkpoint) {
  std::vector<IdentityPart> parts;
  for (const IdentityPart& part : checkpoint.identity)
    if (part.name == name) parts.push_back(part);
  return parts;
}

constexpr double ROUNDED = 1e-10; // of the largest coordinate: FreeFEM's mesh files have twelve digits

template <int Dim> bool same_but_for_rounding(const Mesh<Dim>& a, const Mesh<Dim>& b) {
  if (a.X.size() != b.X.size() || a.connectivity != b.connectivity || a.axisymmetric != b.axisymmetric)
    return false;
  double largest = 0, difference = 0;
  for (std::size_t d = 0; d < a.X.size(); ++d) {
    largest = std::max(largest, std::abs(a.X[d]));
    difference = std::max(difference, std::abs(a.X[d] - b.X[d]));
  }
  return difference <= ROUNDED * largest;
}

// The mesh at the end of the run, which may be another one than it began on.
template <int Dim>
void require_mesh_of(const std::string& path, const Checkpoint& checkpoint, const Mesh<Dim>& mesh) {
  const std::vector<IdentityPart> now{{"mesh", mesh_words<Dim>(mesh)}};
  if (checkpoint.mesh.empty()) return require_same(path, parts_named("mesh", checkpoint), now);
  const Mesh<Dim> then = unpacked_mesh<Dim>(checkpoint.mesh).mesh;
  if (!same_but_for_rounding(then, mesh)) require_same(path, {{"mesh", mesh_words(then)}}, now);
}

} // namespace

template <int Dim>
StageStart start_stage(const std::string& path, const std::vector<char>& fixed, Workpiece<Dim>& workpiece) {
  const Checkpoint checkpoint = read_checkpoint(path);
  require_mesh_of<Dim>(path, checkpoint, workpiece.discretization());
  StageStart start;
  start.t = checkpoint.t;
  const auto material = parts_named("material", checkpoint);
  start.same_material = !material.empty() && material.front().value == material_words(workpiece);
  workpiece.set_state(unpacked<Dim>(checkpoint.state).body.workpiece);
  start.balance = out_of_balance(workpiece, fixed);
  return start;
}

template StageStart start_stage<2>(const std::string&, const std::vector<char>&, Workpiece<2>&);
template StageStart start_stage<3>(const std::string&, const std::vector<char>&, Workpiece<3>&);

} // namespace burnish
