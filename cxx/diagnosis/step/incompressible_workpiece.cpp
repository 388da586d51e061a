// A body so close to incompressible that small errors of its volume are large stresses.
#include "diagnosis/known_law.hpp"
#include "diagnosis/observers.hpp"

namespace burnish {
namespace {

constexpr double NEARLY = 100; // K over G: nu = 0.495

template <int Dim>
class IncompressibleWorkpiece final : public ObserverOf<IncompressibleWorkpiece<Dim>, Dim> {
public:
  void explain(const FailedStep<Dim>& step, std::vector<Failure>& causes) const override {
    const MaterialLaw<Dim>* law = known_law(step.workpiece);
    if (!law) return;
    const auto moduli = law->moduli();
    const double K = moduli.at("K"), G = moduli.at("G");
    if (!(K > NEARLY * G)) return;
    Failure failure(Cause::INCOMPRESSIBLE);
    failure.value = K / G;
    failure.allowed = (3 * K - 2 * G) / (6 * K + 2 * G);
    failure.flag = step.workpiece->discretization().nodes_per_element == Dim + 1;
    causes.push_back(failure);
  }
};

} // namespace

BURNISH_OBSERVER(incompressible_workpiece, IncompressibleWorkpiece)

} // namespace burnish
