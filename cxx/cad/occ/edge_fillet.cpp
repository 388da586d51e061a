#include "cad/occ/edge_fillet.hpp"
#include "base/child_process.hpp"
#include "base/temporary.hpp"
#include "cad/occ/occ_guard.hpp"
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <cmath>
#include <csignal>
#include <iomanip>
#include <sstream>
#include <unistd.h>

namespace burnish {

namespace {

constexpr unsigned FILLET_SECONDS = 20;
constexpr int FILLET_HALVINGS = 20, FILLET_REFINEMENTS = 14;
constexpr int FILLET_DIGITS = 3;
constexpr double FILLET_PART = 0.25; // of the largest, that is proposed

double rounded_down(double value, int digits) {
  const double digit = std::pow(10, std::floor(std::log10(value)) - (digits - 1));
  return std::floor(value / digit + 1e-9) * digit;
}

struct Rounding {
  const TopoDS_Shape& body;
  const std::vector<TopoDS_Edge>& edges;
  const std::vector<TopoDS_Face>& beside;
  const OccGuard& guard;

  bool fits(double radius) const {
    bool good = false;
    const std::string thrown = guard.run([&] {
      BRepFilletAPI_MakeFillet fillet(body);
      for (const TopoDS_Edge& edge : edges) fillet.Add(radius, edge);
      fillet.Build();
      good = fillet.IsDone() && BRepCheck_Analyzer(fillet.Shape()).IsValid();
      for (const TopoDS_Face& face : beside) good = good && !fillet.IsDeleted(face);
    });
    return thrown.empty() && good;
  }

  double largest(double size) const {
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
    const double most = rounded_down(fitting, FILLET_DIGITS);
    return fits(most) ? most : 0;
  }
};

} // namespace

FilletRadii radii_that_fit(const TopoDS_Shape& body, const std::vector<TopoDS_Edge>& edges,
                           const std::vector<TopoDS_Face>& beside, double size) {
  const TemporaryFolder folder;
  const ChildEnd end = run_in_child(
      [&] {
        alarm(FILLET_SECONDS);
        const OccGuard guard;
        std::ostringstream text;
        text << std::setprecision(17) << Rounding{body, edges, beside, guard}.largest(size);
        return text.str();
      },
      folder.path() + "/log");
  if (!end.returned) return {};
  const double most = std::stod(end.result);
  return {true, most, most > 0 ? rounded_down(FILLET_PART * most, 1) : 0};
}

} // namespace burnish
