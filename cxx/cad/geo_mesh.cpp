#include "cad/geo_mesh.hpp"
#include "base/error.hpp"
#include "cad/cad_text.hpp"
#include "parallel/first_rank.hpp"
#include <filesystem>
#include <fstream>

namespace burnish {

namespace {

constexpr const char* MESH_GEO = "mesh_geo";

void make_folder_of(const std::string& path) {
  const auto folder = std::filesystem::path(path).parent_path();
  std::error_code code;
  if (!folder.empty()) std::filesystem::create_directories(folder, code);
  if (code) fail(MESH_GEO, "folder \"" + folder.string() + "\" cannot be made: " + code.message());
}

void check_text(const std::string& file, const GeoNumbers& numbers) {
  if (std::filesystem::exists(file) && file_extension(file) != ".geo")
    fail(MESH_GEO, "\"" + file + "\" ends in \"" + file_extension(file) + "\", expected .geo");
  check_cad_text(file, numbers);
}

// What a mesh must have: the elements and their faces, by gmsh's numbers of types and by name.
struct Wanted {
  long element, face;
  const char *elements, *faces, *group, *label;
};
constexpr Wanted TRIANGLES{
    2, 1, "triangles", "curves", "surface needs Physical Surface(1) = {1};", "Physical Curve(3) = {1, 2};"};
constexpr Wanted TETRAHEDRA{4,
                            2,
                            "tetrahedra",
                            "surfaces",
                            "volume needs Physical Volume(1) = {1};",
                            "Physical Surface(3) = {1, 2};"};

// In this format a line of $Elements is: number, type (1 edge, 2 triangle, 4 tetrahedron), how many tags, the first of
// which is the physical group, nodes.
void check_elements(const std::string& file, const std::string& mesh, const Wanted& wanted) {
  bool inside = false, elements = false, labels = false;
  std::ifstream stream(mesh);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("$", 0) == 0) inside = line.rfind("$Elements", 0) == 0;
    long number = 0, type = 0, tags = 0, group = 0;
    if (!inside || !(std::istringstream(line) >> number >> type >> tags >> group)) continue;
    elements = elements || type == wanted.element;
    labels = labels || (type == wanted.face && group > 0);
  }
  if (!elements)
    fail(MESH_GEO, std::string("no ") + wanted.elements + " in the mesh of \"" + file + "\"; with physical " +
                       wanted.faces + " the " + wanted.group);
  if (!labels)
    fail(MESH_GEO,
         "\"" + file + "\" has no physical " + wanted.faces + "; they become the labels: " + wanted.label);
}

void mesh_geo_here(const std::string& file, const std::string& numbers, const std::string& result,
                   const GeoMeshing& meshing) {
  const GeoNumbers parsed = parse_numbers(MESH_GEO, numbers);
  check_text(file, parsed);
  make_folder_of(result);
  const std::string mesh = result + ".msh";
  std::error_code code;
  std::filesystem::remove(mesh, code);
  try {
    const std::string said = gmsh_mesh(file, parsed, mesh, result + ".log", meshing);
    if (!said.empty())
      fail(MESH_GEO,
           "gmsh failed on \"" + file + "\"" + (said[0] == '\n' ? ", its last lines:" : ": ") + said);
    check_elements(file, mesh, meshing.dimension == 3 ? TETRAHEDRA : TRIANGLES);
  } catch (...) {
    std::filesystem::remove(mesh, code);
    throw;
  }
}

} // namespace

void mesh_geo(const std::string& file, const std::string& numbers, const std::string& result,
              const GeoMeshing& meshing) {
  on_first_rank([&] { mesh_geo_here(file, numbers, result, meshing); });
}

} // namespace burnish
