// A symmetric scene meshed whole (ALGORITHMS.md 17.1).
#include "diagnosis/accepted/mirror.hpp"
#include "diagnosis/observers.hpp"

namespace burnish {
namespace {

constexpr double ASYMMETRY = 1e-3; // difference of mirrored displacements over the largest

// Whether the body moves as its mirror image, about the middle of one axis.
struct MirrorState {
  bool possible = true;
  long looks = 0;
  double deviation = 0; // of mirrored displacements over the largest one, the worst [-]
  BURNISH_FIELDS(possible, looks, deviation)
};

template <int Dim> class SymmetricScene final : public ObserverOf<SymmetricScene<Dim>, Dim> {
public:
  static constexpr bool REMEMBERS = true;
  template <class Archive> void remember(Archive& archive) {
    [[maybe_unused]] auto& [state, mirror] = *this; // the mirrors are made of the mesh when they are needed
    archive(state);
  }
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;
  void end(const EndedRun<Dim>& run, std::vector<Statement>& list) const override;

private:
  static bool touches_both_halves(const AcceptedStep<Dim>& step, int axis);
  std::array<MirrorState, Dim> m_state;                         // per axis
  std::array<std::shared_ptr<const Mirror<Dim>>, Dim> m_mirror; // made from the mesh, once
};

template <int Dim> bool SymmetricScene<Dim>::touches_both_halves(const AcceptedStep<Dim>& step, int axis) {
  constexpr double on_it = 1e-6; // nodes on the middle belong to both
  const double middle = middle_of(step.mesh(), axis), size = size_of(step.mesh());
  bool low = false, high = false;
  for (const auto& node : step.touching) {
    const double x = step.mesh().node(step.model().candidates[node.candidate])[axis] - middle;
    low = low || x <= on_it * size;
    high = high || x >= -on_it * size;
  }
  return low && high;
}

// An axis that is none in one step is looked at no more; most are none in the first.
template <int Dim> void SymmetricScene<Dim>::look(const AcceptedStep<Dim>& step, FindingList&) {
  if (!step.workpiece || !step.first_of_ten() || step.touching.empty()) return;
  for (int axis = 0; axis < Dim; ++axis) {
    MirrorState& state = m_state[axis];
    if (axis == 0 && step.mesh().axisymmetric) state.possible = false;
    state.possible = state.possible && touches_both_halves(step, axis);
    if (!state.possible) continue;
    if (!m_mirror[axis])
      m_mirror[axis] = std::make_shared<Mirror<Dim>>(step.mesh(), MeshLocator<Dim>(step.mesh()), axis);
    state.possible = m_mirror[axis]->possible();
    if (!state.possible) continue;
    ++state.looks;
    state.deviation = std::max(state.deviation, m_mirror[axis]->deviation(step.u));
    state.possible = state.deviation <= ASYMMETRY;
  }
}

template <int Dim>
void SymmetricScene<Dim>::end(const EndedRun<Dim>& run, std::vector<Statement>& list) const {
  for (int axis = 0; axis < Dim; ++axis) {
    const MirrorState& mirror = m_state[axis];
    if (!mirror.possible || mirror.looks == 0) continue;
    const std::string name(1, "xyz"[axis]);
    list.push_back({StatementKind::NOT_NEEDED, "symmetry " + name, mirror.deviation, 55,
                    "the scene is symmetric about " + name + " = " +
                        short_number(middle_of(run.step.mesh(), axis)) + ", to " +
                        short_number(mirror.deviation) +
                        " of the largest displacement: half of the mesh, held in " + name +
                        " there by fixed=, gives the same"});
  }
}

} // namespace

BURNISH_OBSERVER(symmetric_scene, SymmetricScene)

} // namespace burnish
