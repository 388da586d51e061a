// rcMeshGeo(file, numbers, result): meshes a .geo file; rcGmsh of edp/rcGmsh.idp reads the result.
#include "mesh/geo_mesh.hpp"
#include "plugin.hpp"

namespace burnish {
namespace {

bool mesh_file(string* const& file, string* const& numbers, string* const& result) {
  return guarded([&] {
    called("rcGmsh", [&] { mesh_geo(*file, *numbers, *result); });
    return true;
  });
}

} // namespace

void register_geo_mesh() {
  Global.Add("rcMeshGeo", "(", new OneOperator3_<bool, string*, string*, string*>(mesh_file));
}

} // namespace burnish
