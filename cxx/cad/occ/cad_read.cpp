// From a CAD file to the curves that a profile may consist of.
#include "base/error.hpp"
#include "cad/occ/cad_curve.hpp"
#include "cad/occ/cad_file.hpp"
#include <algorithm>
#include <set>

namespace burnish {

namespace {

constexpr const char* CAD_READ = "CadCurve";
constexpr double SMOOTH_JOINT = 1e-3; // rad, and part of the speed
constexpr double LARGEST = 1e50;      // of coordinates and derivatives: their squares must not overflow

std::string listed(const std::vector<int>& tags) {
  std::string list;
  for (const int tag : tags) list += (list.empty() ? "" : ", ") + std::to_string(tag);
  return list;
}

void check_tags(const CadFile& file, const std::vector<int>& tags) {
  std::set<int> seen;
  for (const int tag : tags) {
    if (!seen.insert(tag).second) fail(CAD_READ, "curve " + std::to_string(tag) + " is given twice");
    const auto& all = file.curves();
    if (std::binary_search(all.begin(), all.end(), tag)) continue;
    std::string what = "\"" + file.path() + "\" has no curve " + std::to_string(tag);
    const char* kinds[] = {"point", "curve", "surface", "volume"};
    for (const int dimension : {0, 2, 3})
      if (file.has(dimension, tag)) what += std::string(" (there is a ") + kinds[dimension] + " of that tag)";
    fail(CAD_READ, what + ", its curves are " + listed(all));
  }
}

/// Its places of all spans.
std::vector<double> samples(const ExactCurve& curve) {
  const auto& knots = curve.knots();
  const double begin = knots.front(), end = knots.back();
  std::vector<double> u;
  for (int i = 0; i <= 64; ++i) u.push_back(begin + (end - begin) * i / 64);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    for (const double part : {0., 0.3, 0.7}) u.push_back(knots[i] + part * (knots[i + 1] - knots[i]));
  return u;
}

// name: with the kind of curve, shorter: without
void check_points(const ExactCurve& curve, const std::string& name, const std::string& shorter,
                  const std::string& hint) {
  Vector<3> first = Vector<3>::Zero(), aside = first;
  double size = 0, extent = 0;
  bool begun = false;
  for (const double u : samples(curve)) {
    const auto at = curve.evaluate(u);
    for (const Vector<3>& value : {at.x, at.first, at.second}) {
      if (!value.allFinite()) fail(CAD_READ, shorter + " has points that are not finite");
      if (value.cwiseAbs().maxCoeff() > LARGEST)
        fail(CAD_READ,
             shorter + " has points or derivatives beyond 1e50 at " + place_text(at.x.head<2>(), 0));
    }
    if (!begun) first = at.x;
    begun = true;
    if (std::abs(at.x.z()) > std::abs(aside.z())) aside = at.x;
    size = std::max(size, at.x.head<2>().cwiseAbs().maxCoeff());
    extent = std::max(extent, (at.x - first).norm());
  }
  if (std::abs(aside.z()) > 1e-9 * size) {
    std::ostringstream text;
    text << shorter << " is not in the plane z = 0: it passes through (" << aside.x() << ", " << aside.y()
         << ", " << aside.z() << ")" << hint;
    fail(CAD_READ, text.str());
  }
  if (!(extent > 1e-12 * size))
    fail(CAD_READ, name + " has no length: all its points are at " + place_text(first.head<2>(), 0));
}

void check_knots(const ExactCurve& curve, const std::string& name, double scale) {
  const auto& knots = curve.knots();
  for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
    const auto before = curve.evaluate(knots[i], true), after = curve.evaluate(knots[i]);
    const double angle = std::atan2(before.first.cross(after.first).norm(), before.first.dot(after.first));
    const double slow = before.first.norm(), fast = after.first.norm();
    const std::string place = place_text(scale * after.x.head<2>(), scale * after.x.norm());
    std::ostringstream text;
    text << angle * 180 / M_PI;
    if (angle > SMOOTH_JOINT)
      fail(CAD_READ, name + " has a corner of " + text.str() + " degrees at " + place +
                         "; round it with a fillet in the CAD system");
    if (std::abs(fast - slow) > SMOOTH_JOINT * std::max(fast, slow))
      fail(CAD_READ, name + " changes its speed suddenly at " + place + "; split it there in the CAD system");
  }
}

CadPiece read_curve(const CadFile& file, int tag, double scale, bool chosen) {
  const CadEdge& edge = file.edge(tag);
  const std::string number = "curve " + std::to_string(tag), of = " of \"" + file.path() + "\"";
  const std::string name = number + " (" + edge.kind + ")" + of;
  const ExactCurve curve(edge, name);
  const bool several = !chosen && file.curves().size() > 1;
  check_points(curve, name, number + of,
               several ? "; name the curves of the profile (curves = [...]) out of " + listed(file.curves())
                       : "");
  check_knots(curve, name, scale);
  return {tag, curve, scale};
}

} // namespace

std::vector<CadPiece> read_curves(const CadSelection& selection) {
  require(std::isfinite(selection.scale) && selection.scale > 0, CAD_READ, "scale", selection.scale,
          "a finite number > 0");
  const CadFile file(selection.file, parse_numbers(CAD_READ, selection.numbers), selection.seconds);
  check_tags(file, selection.curves);
  std::vector<CadPiece> pieces;
  const bool chosen = !selection.curves.empty();
  for (const int tag : chosen ? selection.curves : file.curves())
    pieces.push_back(read_curve(file, tag, selection.scale, chosen));
  return pieces;
}

} // namespace burnish
