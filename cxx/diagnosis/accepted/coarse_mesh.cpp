// A mesh coarser than the stress gradient, where the tools carried most (ALGORITHMS.md 17.2).
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"
#include "workpiece/stress_error.hpp"

namespace burnish {
namespace {

constexpr double STRESS_ERROR = 0.15; // recovered against computed stress, relative

template <int Dim> class CoarseMesh final : public ObserverOf<CoarseMesh<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_load, m_t, m_stress)
  void look(const AcceptedStep<Dim>& step, FindingList&) override {
    if (!step.workpiece || !step.first_of_ten()) return;
    double load = 0;
    for (const auto& node : step.touching) load += node.force.F.norm();
    if (!(load > 0 && load >= m_load)) return;
    m_load = load;
    m_t = step.t;
    m_stress = step.workpiece->state_old().stress;
  }
  void end(const EndedRun<Dim>& run, std::vector<Statement>& list) const override {
    if (m_stress.empty() || run.findings.holds("locking", "")) return; // P1 that locks: said already
    const Discretization<Dim>& space = run.step.workpiece->discretization();
    const StressError error = stress_error(space, m_stress);
    if (!(error.relative > STRESS_ERROR)) return;
    Vector<Dim> place = Vector<Dim>::Zero();
    for (int v = 0; v <= Dim; ++v) place += space.node(space.element(error.worst)[v]) / (Dim + 1);
    list.push_back({StatementKind::NEEDED, "stress error", error.relative, 85,
                    "the mesh is coarser than the stress gradient: stress and its nodal recovery differ by " +
                        short_number(100 * error.relative) + " % at t = " + short_number(m_t) +
                        ", most in the element at " + place_text(run.step.place_of(place)) +
                        " of the undeformed body: a finer mesh there resolves it"});
  }

private:
  double m_load = 0, m_t = 0;   // [force, time]
  std::vector<double> m_stress; // Kirchhoff stress, as WorkpieceState::stress
};

} // namespace

BURNISH_OBSERVER(coarse_mesh, CoarseMesh)

} // namespace burnish
