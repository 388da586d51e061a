#include "cad/cad_library.hpp"
#include "base/companion_library.hpp"
#include "cad/companion_occ/burnish_cad.hpp"

namespace burnish {

namespace {

template <class Call> Call* occ_function(const char* name) {
  constexpr const char* file = "burnish_cad.so";
  static void* const library = open_companion(file, "OpenCASCADE", "libocct-data-exchange-dev");
  return reinterpret_cast<Call*>(companion_function(library, file, name));
}

} // namespace

std::shared_ptr<Profile<2>> open_cad_curve(const CadSelection& selection) {
  static const auto call = occ_function<burnish_cad_curve_call>(BURNISH_CAD_CURVE);
  std::shared_ptr<Profile<2>> curve;
  call(selection, curve);
  return curve;
}

std::shared_ptr<const Surface<3>> open_cad_surface(const CadSelection& selection) {
  static const auto call = occ_function<burnish_cad_surface_call>(BURNISH_CAD_SURFACE);
  std::shared_ptr<const Surface<3>> surface;
  call(selection, surface);
  return surface;
}

bool open_cad_has_faces(const std::string& file) {
  static const auto call = occ_function<burnish_cad_has_faces_call>(BURNISH_CAD_HAS_FACES);
  return call(file);
}

} // namespace burnish
