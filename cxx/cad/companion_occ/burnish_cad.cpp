#include "cad/companion_occ/burnish_cad.hpp"
#include "cad/occ/cad_curve.hpp"
#include "cad/occ/cad_surface.hpp"

void burnish_cad_curve(const burnish::CadSelection& selection, std::shared_ptr<burnish::Profile<2>>& curve) {
  curve = std::make_shared<burnish::CadCurve>(selection);
}

void burnish_cad_surface(const burnish::CadSelection& selection,
                         std::shared_ptr<const burnish::Surface<3>>& surface) {
  surface = std::make_shared<burnish::CadSurface>(selection);
}

bool burnish_cad_has_faces(const std::string& file) { return burnish::has_faces_in_space(file); }
