// Meshes of .geo files.
//   rcMeshGeo(file, numbers, result)   meshes a .geo file; rcGmsh (edp/mesh/rcGmsh.idp) reads the result
//     file      the .geo file; without a folder: here, else beside the script
//     numbers   for its DefineConstants, "NAME=VALUE; ..." or ""
//     result    path and name, without ending, of the files written
#include "cad/geo_mesh.hpp"
#include "plugin.hpp"
#include "script_options.hpp"

namespace burnish {
namespace {

bool mesh_file(string* const& file, string* const& numbers, string* const& result) {
  return guarded([&] {
    called("rcGmsh", [&] { mesh_geo(script_options().found(*file), *numbers, *result); });
    return true;
  });
}

} // namespace

void register_geo_mesh() {
  Global.Add("rcMeshGeo", "(", new OneOperator3_<bool, string*, string*, string*>(mesh_file));
}

} // namespace burnish
