#include "cad/companion_gmsh/burnish_gmsh.h"
#include "base/memory_limit.hpp"
#include "cad/companion_gmsh/session.hpp"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <gmsh.h>
#include <set>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <vector>

using namespace burnish_gmsh;

namespace {

using Numbers = std::vector<burnish_gmsh_number>;

constexpr double MEMORY = 2e9; // bytes
constexpr double WAITING = 10; // seconds waited for a second of computing

/// What reading may take of the machine, while it lives.
class Limits {
public:
  explicit Limits(double seconds) : m_memory(MEMORY) {
    getrlimit(RLIMIT_CPU, &m_cpu);
    rusage used;
    getrusage(RUSAGE_SELF, &used);
    rlimit limit = m_cpu;
    limit.rlim_cur =
        static_cast<rlim_t>(static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) + seconds + 1);
    setrlimit(RLIMIT_CPU, &limit);
    alarm(static_cast<unsigned>(WAITING * seconds + 1));
  }
  ~Limits() {
    alarm(0);
    setrlimit(RLIMIT_CPU, &m_cpu);
  }
  Limits(const Limits&) = delete;
  Limits& operator=(const Limits&) = delete;

private:
  rlimit m_cpu;
  burnish::MemoryLimit m_memory;
};

// Names with values before a DefineConstant are taken by it ...
std::string before(const Numbers& numbers) {
  std::ostringstream script;
  script.precision(17);
  for (const auto& number : numbers) script << number.name << " = " << number.value << ";\n";
  return script.str();
}

// ... but overwritten by a plain assignment.
std::string after(const Numbers& numbers) {
  std::ostringstream script;
  script.precision(17);
  for (const auto& number : numbers)
    script << "If (" << number.name << " != " << number.value << ")\n  Error(\"it gives " << number.name
           << " another value, %g; write DefineConstant[ " << number.name << " = ... ] there\", "
           << number.name << ");\nEndIf\n";
  return script.str();
}

// (Not one script with a Merge in it: gmsh 4.8.4 reads freed memory after a nested Merge.)
std::string merge(const std::string& file, const Numbers& numbers, const std::string& folder) {
  const std::string first = folder + "/before.geo", last = folder + "/after.geo";
  std::ofstream(first) << before(numbers) << "\n";
  std::ofstream(last) << after(numbers) << "\n";
  for (const std::string& path : {first, file, last}) {
    if (numbers.empty() && path != file) continue;
    gmsh::merge(path);
    const std::string said = first_error();
    if (!said.empty()) return said;
  }
  return "";
}

void write_curve(std::FILE* out, int tag, bool exact) {
  std::vector<double> begin, end, u, x;
  std::string kind;
  gmsh::model::getType(1, tag, kind);
  gmsh::model::getParametrizationBounds(1, tag, begin, end);
  begin.resize(1, 0);
  end.resize(1, 0);
  for (const double place : burnish_gmsh_place) u.push_back(begin[0] + place * (end[0] - begin[0]));
  gmsh::model::getValue(1, tag, u, x);
  x.resize(3 * u.size(), 0);
  std::fprintf(out, "1 %d %d", tag, exact);
  for (const double value : x) std::fprintf(out, " %.17g", value);
  std::fprintf(out, " %s\n", kind.c_str());
}

bool write_entities(const std::string& folder) {
  std::FILE* out = std::fopen((folder + "/entities").c_str(), "w");
  if (!out) return false;
  gmsh::vectorpair all, occ;
  gmsh::model::getEntities(all);
  gmsh::model::occ::getEntities(occ, 1);
  const std::set<std::pair<int, int>> exact(occ.begin(), occ.end());
  for (const auto& entity : all)
    if (entity.first == 1)
      write_curve(out, entity.second, exact.count(entity) > 0);
    else
      std::fprintf(out, "%d %d\n", entity.first, entity.second);
  if (std::fclose(out) != 0) return false;
  if (exact.size() < all.size()) gmsh::write(folder + "/builtin.geo_unrolled");
  if (exact.empty()) return true;
  // without surfaces and volumes the curves are written in the order of their tags
  for (const int dimension : {3, 2}) {
    gmsh::vectorpair bodies;
    gmsh::model::getEntities(bodies, dimension);
    gmsh::model::removeEntities(bodies);
  }
  gmsh::write(folder + "/opencascade.brep");
  return true;
}

// (gmsh would be busy with them for minutes)
std::string not_finite() {
  gmsh::vectorpair points;
  gmsh::model::getEntities(points, 0);
  for (const auto& point : points) {
    std::vector<double> x;
    gmsh::model::getValue(0, point.second, {}, x);
    for (const double value : x)
      if (!std::isfinite(value)) return "point " + std::to_string(point.second) + " is not finite";
  }
  return "";
}

} // namespace

const char* burnish_gmsh_curves(const char* file, const burnish_gmsh_number* numbers, int count,
                                const char* folder, double seconds) {
  return without_exceptions([&]() -> std::string {
    start(false);
    const Limits limits(seconds);
    const std::string said = merge(file, Numbers(numbers, numbers + count), folder);
    if (!said.empty()) return said;
    return write_entities(folder) ? first_error() : "its curves cannot be written: is the disk full?";
  });
}

const char* burnish_gmsh_mesh(const char* file, const burnish_gmsh_number* numbers, int count,
                              const char* folder, const char* result, int dimension, const char* sizes) {
  return without_exceptions([&]() -> std::string {
    start(true);
    if (!merge(file, Numbers(numbers, numbers + count), folder).empty()) return last_lines();
    const std::string wrong = not_finite();
    if (!wrong.empty()) return wrong;
    if (*sizes) {
      const std::string last = std::string(folder) + "/sizes.geo";
      std::ofstream(last) << sizes;
      gmsh::merge(last);
    }
    gmsh::model::mesh::generate(dimension);
    if (!first_error().empty()) return last_lines();
    gmsh::option::setNumber("Mesh.MshFileVersion", 2.2);
    gmsh::option::setNumber("Mesh.Binary", 0);
    gmsh::write(result);
    return first_error().empty() ? "" : last_lines();
  });
}
