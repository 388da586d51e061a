#pragma once
// What a fillet at a sharp edge or corner may be.
#include <functional>
#include <string>

namespace burnish {

struct FilletRadii {
  bool known = false; ///< false: OpenCASCADE crashed, or took longer than 20 s
  double most = 0;    ///< the largest that fits, three digits, rounded down; 0: none that was tried [length]
  double proposed =
      0; ///< a quarter of it, one digit, rounded down: with the same at the opposite edges half of the face stays
};

/// The largest radius that fits: halved from `size` until one does, then between that and the last that did not; 0: none.
/// @param size  radius beyond which nothing can fit [length]
double largest_radius(double size, const std::function<bool(double)>& fits);
/// From that radius.
FilletRadii radii_of(double largest);
/// ": radius 0.4, at most 1.99", in the tool's unit; ": none fits" or "" if that is not known. @param where " at all 3 edges", or ""
std::string fillet_text(const FilletRadii& radii, double scale, const std::string& where = "");

} // namespace burnish
