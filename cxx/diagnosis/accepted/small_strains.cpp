// Strains and rotations that are small everywhere (ALGORITHMS.md 17.1).
#include "diagnosis/known_law.hpp"
#include "diagnosis/observers.hpp"
#include "material/gradient.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr double SMALL = 1e-3; // |F - I|: below everywhere, the linear form gives the same
constexpr double LARGE = 0.05; // above somewhere, the linear form is in doubt
constexpr double NONE = 1e-6;  // below everywhere, units may be mixed

template <int Dim> class SmallStrains final : public ObserverOf<SmallStrains<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_gradient)
  void look(const AcceptedStep<Dim>& step, FindingList&) override {
    if (!step.workpiece || !step.first_of_ten()) return;
    const Gradient<Dim> I = undeformed<Dim>();
    double squared = 0;
    for (int p = 0; p < step.workpiece->discretization().num_points(); ++p)
      squared = std::max(squared, (point_state(step.workpiece->state_old(), p).F - I).squaredNorm());
    m_gradient = std::max(m_gradient, std::sqrt(squared));
  }
  void end(const EndedRun<Dim>& run, std::vector<Statement>& list) const override {
    if (run.step.workpiece->law().small_strain()) return judge_linear(list);
    if (!(m_gradient <= SMALL) || !(m_gradient > 0)) return;
    const char* option = flowed(*run.step.workpiece) ? ", and so does update=\"single\"" : "";
    list.push_back(
        {StatementKind::NOT_NEEDED, "strain", m_gradient, 20,
         "strains and rotations are at most " + short_number(m_gradient) +
             " everywhere: the geometrically linear form, strain=\"small\" of rcMaterial, gives the same" +
             option +
             (m_gradient < NONE ? "; strains so small are right only if lengths, forces and stresses are in "
                                  "units of one system"
                                : "")});
  }

private:
  void judge_linear(std::vector<Statement>& list) const {
    if (m_gradient > LARGE)
      list.push_back({StatementKind::NEEDED, "strain", m_gradient, 20,
                      "strains and rotations are up to " + short_number(m_gradient) +
                          ", and strain=\"small\" leaves out what is of their second order: "
                          "strain=\"large\" of rcMaterial has it"});
  }

  double m_gradient = 0; // largest |F - I| [-]
};

} // namespace

BURNISH_OBSERVER(small_strains, SmallStrains)

} // namespace burnish
