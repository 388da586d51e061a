// A run on a new mesh of its deformed workpiece (ALGORITHMS.md 19); rcRemesh (edp/run/rcRemesh.idp) makes the mesh, too.
//   S.remeshdue   the elements are bad: the worst has a shape below 0.3, and below half of its first one; or the steps crawl since an
//       element would turn inside out
//   S.remeshings   number of new meshes in this run | -
//   S.remeshchange(name)   largest relative change by one of them, 0 without any | -
//     name      "volume", "energy", "force"
//     ! , expected volume, energy or force
//   M.shape     shape of the worst element where it is now: 1 equilateral, 0 flat | -
//   M.volume    of the workpiece where it is now: area, of a ring and in space volume | length^2, length^3
//   M.outline(size)   boundary of the deformed workpiece as straight edges: for each x, y of its start, x, y of its end, label; the
//       body is on the left. Corners and ends of labels stay | length
//     size      length of an edge, 0: that of the present mesh there | length | | >= 0
//   M.volumemesh(size)   mesh3 of the deformed workpiece in space, made by gmsh: labels and sharp edges stay, vertices are on its surface
//     size      length of the edges, or an array of them at the vertices of the present mesh; 0.: as long as those of the first mesh there | length
//     ! one region
//     ! gmsh failed on the deformed workpiece
//   rcOnNewMesh(S, C, M, Vh, u, held)   between steps, as in record: contact, material and run go on on the mesh of Vh, of the
//       deformed workpiece, with u = 0 but for the mid nodes of its boundary. Stress, internal variables and integrities are
//       carried over (METHOD.md 1.17), tools stay where they are, supports and a hold go on, equilibrium is found again. External forces are
//       to be given anew. Prints how far force, stored energy and volume are apart, and returns that of the force over the largest force | -
//     S         stepcontrol of the run, or of the run to come
//     C         contact
//     M         material of the run
//     Vh        fespace of the displacement on the new mesh, of the same degree
//     u         displacement array, u[], out | length
//     held      nonzero where the displacement is given, as fixed= of rcContact
//     ! , expected a mesh of the deformed workpiece
//     ! forces act at the undeformed place
//     ! expected supports that move as a whole
//     ! expected the same supports while they move
//     ! in the middle of a step
#include "remesh.hpp"
#include "mesh/mesh_match.hpp"
#include "named.hpp"
#include "remesh/deformed_boundary.hpp"
#include "remesh/volume_mesh.hpp"
#include "step_control.hpp"
#include <algorithm>
#include <cmath>
#include <optional>

namespace burnish {
namespace {

using M = MaterialHandle;
using S = StepControlHandle;

void tell(const Remeshing& report) {
  cout << "burnish: new mesh at t = " << report.t << ": " << report.after.nodes << " nodes, "
       << report.before.nodes << " before; shape " << report.before.shape << " -> " << report.after.shape
       << "; apart: volume " << report.volume() << ", stored energy " << report.energy() << ", force "
       << report.force() << "; ";
  if (report.settled)
    cout << report.iterations << " iterations to equilibrium" << endl;
  else
    cout << "equilibrium is left to the next step" << endl;
}

// What has taken the place of its contact and body begins the run anew, at the accepted state.
template <int Dim>
void go_on(const std::shared_ptr<ControlObject>& control, ContactOf<Dim>& contact, MaterialOf<Dim>& material,
           RunState<Dim> state) {
  state.body = material.body->state();
  state.contact = contact.run().state();
  Stepper<Dim>& stepper = begin_stepper<Dim>(control, contact, material);
  state.diagnosis = contact.diagnosis; // begins anew
  Eigen::VectorXd R;
  stepper.set_state(state, control->u, R);
  control->statements_at = -1;
}

template <int Dim> struct OnNewMesh {
  static const int n = 0;
  static constexpr basicAC_F0::name_and_type* names = nullptr;
  static double call(const Named&, S* s, ContactHandle* c, M* m, typename Freefem<Dim>::Fespace* space,
                     KN_<double> u, KN_<double> held) {
    constexpr const char* WHERE = "rcOnNewMesh";
    const std::shared_ptr<ControlObject> shared = s->share();
    ControlObject& control = *shared;
    auto& contact = of_dimension<Dim>(c->get(), WHERE);
    auto& material = contact.with_material(m->get(), WHERE);
    const bool known = control.stepper && control.contact.get() == &contact;
    if (contact.under_way && (!known || control.task != Task::RECORD))
      fail(WHERE, "a run in the middle of a step, or of another stepcontrol, expected one that has just "
                  "recorded a step");
    std::optional<RunState<Dim>> running;
    if (known) running = static_cast<Stepper<Dim>&>(*control.stepper).state();
    const bool ring = material.workpiece().discretization().axisymmetric;
    const Eigen::VectorXd flags = to_vector(held, WHERE, "held");
    std::vector<char> fixed;
    for (const double flag : flags) fixed.push_back(flag != 0);
    RemeshedRun<Dim> result = called(WHERE, [&] {
      return remeshed(material.workpiece(), contact.run(), control.now().time(),
                      discretized(mesh_of<Dim>(space, WHERE, ring)), std::move(fixed));
    });
    const Remeshing report = result.report;
    take_mesh<Dim>(contact, material, std::move(result), shared_mesh<Dim>(space, WHERE));
    if (running) go_on<Dim>(shared, contact, material, std::move(*running));
    control.remeshed = control.remeshed || running;
    to_array(material.workpiece().state_old().displacement, u, WHERE);
    control.remeshings.push_back(report);
    tell(report);
    return report.force();
  }
};

bool due(S* const& s) {
  return guarded([&] {
    const ControlObject& control = s->get();
    if (!control.stepper) return false; // in record before the first step
    return visit(*control.material,
                 [&](auto& material) { return remesh_due(material.workpiece(), *control.stepper); });
  });
}
long remeshings(S* const& s) { return static_cast<long>(s->get().remeshings.size()); }
struct ChangeTag {};
double change(const Method<S, ChangeTag>& m, string* const& name) {
  return guarded([&] {
    const bool volume = *name == "volume", energy = *name == "energy";
    if (!volume && !energy && *name != "force")
      fail("stepcontrol.remeshchange", "unknown name \"" + *name + "\", expected volume, energy or force");
    double largest = 0;
    for (const Remeshing& one : m->get().remeshings)
      largest = std::max(largest, std::abs(volume ? one.volume() : energy ? one.energy() : one.force()));
    return largest;
  });
}
double shape(M* const& m) {
  return on(m, [](auto& material) { return least_shape(material.workpiece()); });
}
double volume(M* const& m) {
  return on(m, [](auto& material) { return deformed_volume(material.workpiece()); });
}

struct OutlineTag {};
KN_<double> outline_of(Stack stack, const Method<M, OutlineTag>& m, const double& size) {
  return guarded([&] {
    const auto& body = of_dimension<2>(m->get(), "material.outline").workpiece();
    std::vector<double> values;
    for (const OutlineEdge& edge : called("material.outline", [&] {
           return outline(body.discretization(), body.state_old().displacement, size);
         }))
      values.insert(values.end(),
                    {edge.from[0], edge.from[1], edge.to[0], edge.to[1], static_cast<double>(edge.label)});
    return new_array(stack, values);
  });
}

struct VolumeMeshTag {};
constexpr const char* VOLUME_MESH = "material.volumemesh";
// It goes with the stack.
pmesh3 mesh_of(Stack stack, const VolumeMesh& from, int region) {
  using namespace Fem2D;
  auto* places = new Vertex3[from.node.size()];
  auto* elements = new Tet[from.tetrahedron.size()];
  auto* faces = new Triangle3[from.face.size()];
  for (std::size_t i = 0; i < from.node.size(); ++i)
    static_cast<R3&>(places[i]) = R3(from.node[i][0], from.node[i][1], from.node[i][2]);
  for (std::size_t k = 0; k < from.tetrahedron.size(); ++k) {
    std::array<int, 4> corners = from.tetrahedron[k];
    elements[k].set(places, corners.data(), region);
  }
  for (std::size_t b = 0; b < from.face.size(); ++b) {
    std::array<int, 3> corners = from.face[b];
    faces[b].set(places, corners.data(), static_cast<int>(from.label[b]));
  }
  // (without its MeshS: FreeFEM writes beyond an array of its edges on some surfaces)
  auto* mesh = new ::Mesh3(static_cast<int>(from.node.size()), static_cast<int>(from.tetrahedron.size()),
                           static_cast<int>(from.face.size()), places, elements, faces);
  return Add2StackOfPtr2FreeRC(stack, mesh);
}
// @param make volume_mesh of a workpiece's mesh and displacement, of FreeFEM's mesh
template <class Make> pmesh3 meshed_by(Stack stack, const Method<M, VolumeMeshTag>& m, const Make& make) {
  return guarded([&] {
    const auto& material = of_dimension<3>(m->get(), VOLUME_MESH, "; in the plane rcOutlineMesh does it");
    const ::Mesh3& old = *material.mesh;
    for (int k = 0; k < old.nt; ++k)
      require(old[k].lab == old[0].lab, VOLUME_MESH, "region", old[k].lab, "one region");
    const auto& body = material.workpiece();
    return called(VOLUME_MESH, [&] {
      return mesh_of(stack, make(body.discretization(), body.state_old().displacement, old), old[0].lab);
    });
  });
}
pmesh3 meshed_evenly(Stack stack, const Method<M, VolumeMeshTag>& m, const double& size) {
  return meshed_by(stack, m, [&](const auto& mesh, const Eigen::VectorXd& u, const ::Mesh3& old) {
    return size == 0 ? volume_mesh(mesh, u) : volume_mesh(mesh, u, CornerSizes::Constant(4, old.nt, size));
  });
}
pmesh3 meshed_as_told(Stack stack, const Method<M, VolumeMeshTag>& m, const KN_<double>& size) {
  return meshed_by(stack, m, [&](const auto& mesh, const Eigen::VectorXd& u, const ::Mesh3& old) {
    require(size.N() == old.nv, VOLUME_MESH, "number of lengths of edges", size.N(),
            (std::to_string(old.nv) + ", one for each vertex").c_str());
    CornerSizes sizes(4, old.nt);
    for (int k = 0; k < old.nt; ++k)
      for (int v = 0; v < 4; ++v) sizes(v, k) = size[old(k, v)];
    return volume_mesh(mesh, u, sizes);
  });
}

} // namespace

template <int Dim>
void take_mesh(ContactOf<Dim>& contact, MaterialOf<Dim>& material, RemeshedRun<Dim> there,
               std::shared_ptr<const typename Freefem<Dim>::Mesh> mesh) {
  contact.end_runs();
  contact.replace(std::move(there.setup), std::move(there.contact));
  material.changed().replace(std::move(there.workpiece), there.origin);
  material.mesh = std::move(mesh);
  material.fingerprint = mesh_fingerprint<Dim>(material.workpiece().discretization());
}
template void take_mesh<2>(ContactOf<2>&, MaterialOf<2>&, RemeshedRun<2>, std::shared_ptr<const ::Mesh>);
template void take_mesh<3>(ContactOf<3>&, MaterialOf<3>&, RemeshedRun<3>, std::shared_ptr<const ::Mesh3>);

void register_remesh() {
  Add<S*>("remeshdue", ".", new OneOperator1_<bool, S*>(due));
  Add<S*>("remeshings", ".", new OneOperator1_<long, S*>(remeshings));
  add_method<S, ChangeTag>("remeshchange",
                           [] { return new OneOperator2_<double, Method<S, ChangeTag>, string*>(change); });
  Add<M*>("shape", ".", new OneOperator1_<double, M*>(shape));
  Add<M*>("volume", ".", new OneOperator1_<double, M*>(volume));
  add_method<M, OutlineTag>(
      "outline", [] { return new OneOperator2s_<KN_<double>, Method<M, OutlineTag>, double>(outline_of); });
  add_method<M, VolumeMeshTag>(
      "volumemesh",
      [] { return new OneOperator2s_<pmesh3, Method<M, VolumeMeshTag>, double>(meshed_evenly); },
      [] { return new OneOperator2s_<pmesh3, Method<M, VolumeMeshTag>, KN_<double>>(meshed_as_told); });
  Global.Add(
      "rcOnNewMesh", "(",
      new NamedOperator<OnNewMesh<2>, double, S*, ContactHandle*, M*, pfes*, KN_<double>, KN_<double>>);
  Global.Add(
      "rcOnNewMesh", "(",
      new NamedOperator<OnNewMesh<3>, double, S*, ContactHandle*, M*, pfes3*, KN_<double>, KN_<double>>);
}

} // namespace burnish
