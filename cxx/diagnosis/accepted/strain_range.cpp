// Range of the law (ALGORITHMS.md 16.4).
#include "base/sentence.hpp"
#include "diagnosis/known_law.hpp"
#include "diagnosis/observers.hpp"
#include "material/gradient.hpp"
#include "material/j2/law.hpp"
#include <Eigen/SVD>

namespace burnish {
namespace {

// With the Jaumann rate:
constexpr Bounds STRAIN{0.3, 2};  // accumulated plastic strain
constexpr Bounds ELASTIC{0.1, 1}; // principal logarithmic strain of a body that does not flow

template <int Dim> bool with_jaumann_rate(const Workpiece<Dim>& workpiece) {
  const auto* law = dynamic_cast<const J2Law<Dim>*>(&workpiece.law());
  return law && law->parameters().rate == CorotationalRate::JAUMANN;
}

template <int Dim> class StrainCheck final : public ObserverOf<StrainCheck<Dim>, Dim> {
public:
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;

private:
  void look_at_elastic(const AcceptedStep<Dim>& step, FindingList& findings) const;
};

// Elastic or not, the stress of the Jaumann rate depends on the way: a closed one leaves stresses behind.
template <int Dim>
void StrainCheck<Dim>::look_at_elastic(const AcceptedStep<Dim>& step, FindingList& findings) const {
  if (!step.tenth()) return;
  double strain = 0;
  int worst = 0;
  for (int p = 0; p < step.workpiece->discretization().num_points(); ++p) {
    const Gradient<Dim> F = point_state(step.workpiece->state_old(), p).F;
    const Vector<Dim> stretch = Eigen::JacobiSVD<Tensor<Dim>>(mesh_part<Dim>(F)).singularValues();
    const double largest = stretch.array().log().abs().maxCoeff();
    if (!(largest > strain)) continue;
    strain = largest;
    worst = p;
  }
  Finding* finding = findings.beyond("elastic strain", "", strain, ELASTIC, step.t);
  if (!finding) return;
  const Vector<Dim> x = step.point(worst);
  finding->place = step.place_of(x);
  finding->text =
      sentence("the strain of an elastic workpiece is ", strain, step.at(x),
               ": with the Jaumann rate its stress "
               "depends on the way, and a closed one leaves stresses behind; take rate=\"logarithmic\"");
}

template <int Dim> void StrainCheck<Dim>::look(const AcceptedStep<Dim>& step, FindingList& findings) {
  const bool known = known_law(step.workpiece) != nullptr;
  if (!known && (!step.workpiece || !with_jaumann_rate(*step.workpiece))) return;
  Eigen::Index worst = 0;
  const double strain = plastic_strains(*step.workpiece).maxCoeff(&worst);
  findings.largest("plastic strain", strain);
  if (!with_jaumann_rate(*step.workpiece)) return;
  if (!(strain > 0)) look_at_elastic(step, findings);
  if (!(strain > STRAIN.noted)) return;
  // of a script's law for such a material the rate is not known for certain
  Finding* finding =
      findings.beyond("plastic strain", "", strain, known ? STRAIN : Bounds{STRAIN.noted}, step.t);
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
