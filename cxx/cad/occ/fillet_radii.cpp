#include "cad/occ/fillet_radii.hpp"
#include "base/sentence.hpp"
#include <cmath>

namespace burnish {

namespace {

constexpr int FILLET_HALVINGS = 20, FILLET_REFINEMENTS = 14;
constexpr int FILLET_DIGITS = 3;
constexpr double FILLET_PART = 0.25; // of the largest, that is proposed

double rounded_down(double value, int digits) {
  const double digit = std::pow(10, std::floor(std::log10(value)) - (digits - 1));
  return std::floor(value / digit + 1e-9) * digit;
}

} // namespace

double largest_radius(double size, const std::function<bool(double)>& fits) {
  double fitting = size, not_any_more = size;
  for (int i = 0; !fits(fitting); ++i) {
    if (i == FILLET_HALVINGS) return 0;
    not_any_more = fitting;
    fitting /= 2;
  }
  for (int i = 0; i < FILLET_REFINEMENTS; ++i) {
    const double middle = (fitting + not_any_more) / 2;
    (fits(middle) ? fitting : not_any_more) = middle;
  }
  return fitting;
}

FilletRadii radii_of(double largest) {
  if (!(largest > 0)) return {true, 0, 0};
  const double most = rounded_down(largest, FILLET_DIGITS);
  return {true, most, rounded_down(FILLET_PART * most, 1)};
}

std::string fillet_text(const FilletRadii& radii, double scale, const std::string& where) {
  if (!radii.known) return "";
  if (radii.most == 0) return ": none fits" + where;
  return sentence(": radius ", scale * radii.proposed, ", at most ", scale * radii.most, where);
}

} // namespace burnish
