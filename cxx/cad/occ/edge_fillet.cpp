#include "cad/occ/edge_fillet.hpp"
#include "base/child_process.hpp"
#include "base/temporary.hpp"
#include "cad/occ/occ_guard.hpp"
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <csignal>
#include <iomanip>
#include <sstream>
#include <unistd.h>

namespace burnish {

namespace {

constexpr unsigned FILLET_SECONDS = 20;

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
        text << std::setprecision(17) << largest_radius(size, [&](double radius) {
          return Rounding{body, edges, beside, guard}.fits(radius);
        });
        return text.str();
      },
      folder.path() + "/log");
  if (!end.returned) return {};
  return radii_of(std::stod(end.result));
}

} // namespace burnish
