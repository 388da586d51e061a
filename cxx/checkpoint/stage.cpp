#include "checkpoint/stage.hpp"
#include "checkpoint/identity.hpp"
#include "remesh/stored_mesh.hpp"
#include "run/run_archive.hpp"

namespace burnish {

template <int Dim>
StageStart start_stage(const std::string& path, const std::vector<char>& fixed, Workpiece<Dim>& workpiece) {
  const Checkpoint checkpoint = read_checkpoint(path);
  const auto then = [&](const char* name) {
    std::vector<IdentityPart> parts;
    for (const IdentityPart& part : checkpoint.identity)
      if (part.name == name) parts.push_back(part);
    return parts;
  };
  std::vector<IdentityPart> mesh = then("mesh");
  if (!checkpoint.mesh.empty()) mesh = {{"mesh", mesh_words(unpacked_mesh<Dim>(checkpoint.mesh).mesh)}};
  require_same(path, mesh, {{"mesh", mesh_words<Dim>(workpiece.discretization())}});
  StageStart start;
  start.t = checkpoint.t;
  const auto material = then("material");
  start.same_material = !material.empty() && material.front().value == material_words(workpiece);
  workpiece.set_state(unpacked<Dim>(checkpoint.state).body.workpiece);
  start.balance = out_of_balance(workpiece, fixed);
  return start;
}

template StageStart start_stage<2>(const std::string&, const std::vector<char>&, Workpiece<2>&);
template StageStart start_stage<3>(const std::string&, const std::vector<char>&, Workpiece<3>&);

} // namespace burnish
