#include "stepping/body_reason.hpp"
#include "checks/known_law.hpp"
#include <sstream>

namespace burnish {

template <int Dim> std::string nearly_incompressible(const Workpiece<Dim>* workpiece) {
  constexpr double bound = 100; // K over G: nu = 0.495
  const MaterialLaw<Dim>* law = workpiece ? known_law(*workpiece) : nullptr;
  if (!law) return "";
  const auto moduli = law->moduli();
  const double K = moduli.at("K"), G = moduli.at("G");
  if (!(K > bound * G)) return "";
  std::ostringstream text;
  text << "the workpiece is nearly incompressible, its bulk modulus " << K / G
       << " times its shear modulus (nu = " << (3 * K - 2 * G) / (6 * K + 2 * G)
       << "): small errors of the volume are large stresses; take nu up to 0.49"
       << (workpiece->discretization().nodes_per_element == Dim + 1 ? ", and P2, since P1 locks" : "");
  return text.str();
}

template std::string nearly_incompressible<2>(const Workpiece<2>*);
template std::string nearly_incompressible<3>(const Workpiece<3>*);

} // namespace burnish
