#pragma once
// CAD curves by the library that is linked with OpenCASCADE, opened when the first one is read: see cad/burnish_cad.hpp.
#include "cad/cad_selection.hpp"
#include "geometry/profile.hpp"
#include <memory>

namespace burnish {

/// CadCurve(selection). @throws std::invalid_argument as it, or if the library is not there
std::shared_ptr<Profile<2>> open_cad_curve(const CadSelection& selection);

} // namespace burnish
