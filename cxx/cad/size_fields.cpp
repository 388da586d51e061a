#include "cad/size_fields.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr double MOST = 5e6; // tetrahedra

// Regular tetrahedra of the lengths in and around a ball: volume over 2^(1/2)/12 L^3.
double number_of(const SizeZone& zone, double coarse, double growth) {
  constexpr double per_cube = 8.485281374238571, four_pi = 12.566370614359172;
  const double R = zone.radius, h = zone.length, ratio = coarse / h;
  // of the integral of r^2/(h + growth (r - R))^3 from R to where the length is coarse
  const double shift = R - h / growth, from = 1 - 1 / ratio;
  const double around = (std::log(ratio) + 2 * shift * growth / h * from +
                         0.5 * std::pow(shift * growth / h, 2) * (1 - 1 / (ratio * ratio))) /
                        std::pow(growth, 3);
  return per_cube * four_pi * (std::pow(R / h, 3) / 3 + around);
}

void check(const SizeZone& zone, double coarse, double growth, const char* where) {
  for (const double x : zone.center) require(std::isfinite(x), where, "place", x, "a finite number");
  require(zone.radius > 0 && std::isfinite(zone.radius), where, "size", zone.radius, "finite > 0");
  require(zone.length > 0 && zone.length < coarse, where, "h", zone.length, "0 < h < coarse");
  const double number = number_of(zone, coarse, growth);
  require(number <= MOST, where, "tetrahedra in and around a zone", number,
          "at most 5e6: longer edges, or a smaller size");
}

} // namespace

std::string size_fields(const std::vector<SizeZone>& zones, double coarse, double growth, const char* where) {
  require(!zones.empty(), where, "number of places", 0, ">= 1");
  require(coarse > 0 && std::isfinite(coarse), where, "coarse", coarse, "finite > 0");
  require(growth > 0 && std::isfinite(growth), where, "growth", growth, "finite > 0");
  std::ostringstream text;
  text.precision(17);
  text << "burnish_field = newf;\n";
  for (std::size_t k = 0; k < zones.size(); ++k) {
    const SizeZone& zone = zones[k];
    check(zone, coarse, growth, where);
    const std::string field = "Field[burnish_field + " + std::to_string(k) + "]";
    text << field << " = Ball;\n";
    for (int c = 0; c < 3; ++c)
      text << field << "."
           << "XYZ"[c] << "Center = " << zone.center[c] << ";\n";
    text << field << ".Radius = " << zone.radius << ";\n"
         << field << ".Thickness = " << (coarse - zone.length) / growth << ";\n"
         << field << ".VIn = " << zone.length << ";\n"
         << field << ".VOut = " << coarse << ";\n";
  }
  const std::string last = "burnish_field + " + std::to_string(zones.size());
  text << "Field[" << last << "] = Min;\nField[" << last << "].FieldsList = {burnish_field : " << last
       << " - 1};\nBackground Field = " << last << ";\n"
       << "Mesh.MeshSizeExtendFromBoundary = 0;\nMesh.MeshSizeFromPoints = 0;\n"
       << "Mesh.MeshSizeFromCurvature = 0;\nMesh.MeshSizeFactor = 1;\nMesh.MeshSizeMin = 0;\n"
       << "Mesh.MeshSizeMax = " << coarse << ";\n";
  return text.str();
}

} // namespace burnish
