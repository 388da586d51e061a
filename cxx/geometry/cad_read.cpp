// From a CAD file to the curves that a profile may consist of.
#include "base/error.hpp"
#include "geometry/cad_curve.hpp"
#include "geometry/cad_file.hpp"
#include <algorithm>
#include <set>

namespace burnish {

namespace {

constexpr const char* WHERE = "CadCurve";

std::string listed(const std::vector<int>& tags) {
  std::string list;
  for (const int tag : tags) list += (list.empty() ? "" : ", ") + std::to_string(tag);
  return list;
}

void check_tags(const CadFile& file, const std::vector<int>& tags) {
  std::set<int> seen;
  for (const int tag : tags) {
    if (!seen.insert(tag).second) fail(WHERE, "curve " + std::to_string(tag) + " is given twice");
    const auto& all = file.curves();
    if (std::binary_search(all.begin(), all.end(), tag)) continue;
    std::string what = "\"" + file.path() + "\" has no curve " + std::to_string(tag);
    const char* kinds[] = {"point", "curve", "surface", "volume"};
    for (const int dimension : {0, 2, 3})
      if (file.has(dimension, tag)) what += std::string(" (there is a ") + kinds[dimension] + " of that tag)";
    fail(WHERE, what + ", its curves are " + listed(all));
  }
}

void check_plane(const CadFile& file, const CadEdge& edge, bool chosen) {
  std::vector<double> u;
  for (int i = 0; i <= 64; ++i) u.push_back(edge.begin + (edge.end - edge.begin) * i / 64);
  const Eigen::Matrix3Xd x = file.value(edge.tag, u);
  Eigen::Index at = 0;
  if (!x.allFinite())
    fail(WHERE,
         "curve " + std::to_string(edge.tag) + " of \"" + file.path() + "\" has points that are not finite");
  const double z = x.row(2).cwiseAbs().maxCoeff(&at), size = x.topRows<2>().cwiseAbs().maxCoeff();
  if (z <= 1e-9 * size) return;
  std::ostringstream text;
  text << "curve " << edge.tag << " of \"" << file.path()
       << "\" is not in the plane z = 0: it passes through (" << x(0, at) << ", " << x(1, at) << ", "
       << x(2, at) << ")";
  if (!chosen && file.curves().size() > 1)
    text << "; name the curves of the profile (curves = [...]) out of " << listed(file.curves());
  fail(WHERE, text.str());
}

CadPiece read_curve(const CadFile& file, int tag, double scale, bool chosen) {
  const CadEdge edge = file.edge(tag);
  check_plane(file, edge, chosen);
  CadSource source;
  source.name = "curve " + std::to_string(tag) + " (" + edge.type + ") of \"" + file.path() + "\"";
  source.begin = edge.begin;
  source.end = edge.end;
  source.value = [&file, tag, scale](const std::vector<double>& u) {
    return Eigen::Matrix2Xd(scale * file.value(tag, u).topRows<2>());
  };
  if (edge.exact_derivative)
    source.derivative = [&file, tag, scale](const std::vector<double>& u) {
      return Eigen::Matrix2Xd(scale * file.derivative(tag, u).topRows<2>());
    };
  return CadPiece(tag, std::make_shared<CadSpans>(source));
}

} // namespace

std::vector<CadPiece> read_curves(const CadSelection& selection) {
  require(std::isfinite(selection.scale) && selection.scale > 0, WHERE, "scale", selection.scale,
          "a finite number > 0");
  const CadFile file(selection.file, parse_numbers(WHERE, selection.numbers));
  check_tags(file, selection.curves);
  std::vector<CadPiece> pieces;
  const bool chosen = !selection.curves.empty();
  for (const int tag : chosen ? selection.curves : file.curves())
    pieces.push_back(read_curve(file, tag, selection.scale, chosen));
  return pieces;
}

} // namespace burnish
