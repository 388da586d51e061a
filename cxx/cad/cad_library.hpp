#pragma once
// CAD curves and faces by the library that is linked with OpenCASCADE, opened when the first one is read: see cad/burnish_cad.hpp.
#include "cad/cad_selection.hpp"
#include "geometry/profile.hpp"
#include "geometry/surface.hpp"
#include <memory>

namespace burnish {

/// CadCurve(selection). @throws std::invalid_argument as it, or if the library is not there
std::shared_ptr<Profile<2>> open_cad_curve(const CadSelection& selection);
/// CadSurface(selection). @throws std::invalid_argument as it, or if the library is not there
std::shared_ptr<const Surface<3>> open_cad_surface(const CadSelection& selection);
/// has_faces_in_space(file). @throws std::invalid_argument if the library is not there
bool open_cad_has_faces(const std::string& file);

} // namespace burnish
