#pragma once
// All that scripts need of OpenCASCADE, in a shared library of its own (burnish_cad.so): only this one is linked with it, and
// it is opened when the first CAD file is read, since the dynamic linker takes longer for OpenCASCADE than a coarse run.
#include "cad/cad_selection.hpp"
#include "geometry/profile.hpp"
#include "geometry/surface.hpp"
#include <memory>

/// curve := CadCurve(selection), exceptions pass.
extern "C" void burnish_cad_curve(const burnish::CadSelection& selection,
                                  std::shared_ptr<burnish::Profile<2>>& curve);
using burnish_cad_curve_call = void(const burnish::CadSelection&, std::shared_ptr<burnish::Profile<2>>&);
#define BURNISH_CAD_CURVE "burnish_cad_curve"

/// surface := CadSurface(selection), exceptions pass.
extern "C" void burnish_cad_surface(const burnish::CadSelection& selection,
                                    std::shared_ptr<const burnish::Surface<3>>& surface);
using burnish_cad_surface_call = void(const burnish::CadSelection&,
                                      std::shared_ptr<const burnish::Surface<3>>&);
#define BURNISH_CAD_SURFACE "burnish_cad_surface"

/// has_faces_in_space(file).
extern "C" bool burnish_cad_has_faces(const std::string& file);
using burnish_cad_has_faces_call = bool(const std::string&);
#define BURNISH_CAD_HAS_FACES "burnish_cad_has_faces"
