#include "cad/cad_library.hpp"
#include "base/companion_library.hpp"
#include "cad/companion_occ/burnish_cad.hpp"

namespace burnish {

std::shared_ptr<Profile<2>> open_cad_curve(const CadSelection& selection) {
  constexpr const char* name = "burnish_cad.so";
  static void* const library = open_companion(name, "OpenCASCADE", "libocct-data-exchange-dev");
  static const auto call =
      reinterpret_cast<burnish_cad_curve_call*>(companion_function(library, name, BURNISH_CAD_CURVE));
  std::shared_ptr<Profile<2>> curve;
  call(selection, curve);
  return curve;
}

} // namespace burnish
