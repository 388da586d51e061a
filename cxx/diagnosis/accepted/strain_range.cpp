// Range of the law (ALGORITHMS.md 16.4).
#include "base/sentence.hpp"
#include "diagnosis/known_law.hpp"
#include "diagnosis/observers.hpp"
#include "material/j2/law.hpp"

namespace burnish {
namespace {

constexpr Bounds STRAIN{0.3, 2}; // accumulated plastic strain with the Jaumann rate

template <int Dim> bool with_jaumann_rate(const Workpiece<Dim>& workpiece) {
  if constexpr (Dim == 2)
    if (const auto* law = dynamic_cast<const J2Law<2>*>(&workpiece.law()))
      return law->parameters().rate == CorotationalRate::JAUMANN;
  return false;
}

template <int Dim> class StrainCheck final : public ObserverOf<StrainCheck<Dim>, Dim> {
public:
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;
};

template <int Dim> void StrainCheck<Dim>::look(const AcceptedStep<Dim>& step, FindingList& findings) {
  if (!known_law(step.workpiece)) return;
  Eigen::Index worst = 0;
  const double strain = plastic_strains(*step.workpiece).maxCoeff(&worst);
  findings.largest("plastic strain", strain);
  if (!with_jaumann_rate(*step.workpiece) || !(strain > STRAIN.noted)) return;
  Finding* finding = findings.beyond("plastic strain", "", strain, STRAIN, step.t);
  if (!finding) return;
  const Vector<Dim> x = step.point(static_cast<int>(worst));
  finding->place = step.place_of(x);
  finding->text = sentence("plastic strain ", strain, step.at(x),
                           " is beyond the range of the law: with the Jaumann rate stresses swing from ",
                           STRAIN.noted, " on; take rate=\"logarithmic\"");
}

} // namespace

BURNISH_OBSERVER(strain_check, StrainCheck)

} // namespace burnish
