#include "cad/companion_occ/burnish_cad.hpp"
#include "cad/occ/cad_curve.hpp"

void burnish_cad_curve(const burnish::CadSelection& selection, std::shared_ptr<burnish::Profile<2>>& curve) {
  curve = std::make_shared<burnish::CadCurve>(selection);
}
