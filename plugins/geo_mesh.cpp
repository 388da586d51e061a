// Meshes of .geo files.
//   rcMeshGeo(file, numbers, result)   meshes a .geo file; rcGmsh (edp/mesh/rcGmsh.idp) reads the result
//     file      the .geo file; without a folder: here, else beside the script
//     numbers   for its DefineConstants, "NAME=VALUE; ..." or ""
//     result    path and name, without ending, of the files written
//   rcMeshGeo3(file, numbers, result, lengths)   the same for the volumes of a file; rcGmsh3 and rcGradedMesh3 read the result
//     file      the .geo file; without a folder: here, else beside the script
//     numbers   for its DefineConstants, "NAME=VALUE; ..." or ""
//     result    path and name, without ending, of the files written
//     lengths   coarse, growth, then x, y, z, size, h of each place, see rcGradedMesh3; one number: those of the file
#include "cad/geo_mesh.hpp"
#include "cad/size_fields.hpp"
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

std::string fields_of(const KN_<double>& lengths) {
  if (lengths.N() < 2) return "";
  std::vector<SizeZone> zones;
  for (long k = 2; k + 4 < lengths.N(); k += 5)
    zones.push_back({{lengths[k], lengths[k + 1], lengths[k + 2]}, lengths[k + 3], lengths[k + 4]});
  return size_fields(zones, lengths[0], lengths[1], "rcGradedMesh3");
}

bool mesh_volumes(string* const& file, string* const& numbers, string* const& result,
                  const KN_<double>& lengths) {
  return guarded([&] {
    const std::string fields = fields_of(lengths);
    called(fields.empty() ? "rcGmsh3" : "rcGradedMesh3", [&] {
      mesh_geo(script_options().found(*file), *numbers, *result, {3, fields});
    });
    return true;
  });
}

} // namespace

void register_geo_mesh() {
  Global.Add("rcMeshGeo", "(", new OneOperator3_<bool, string*, string*, string*>(mesh_file));
  Global.Add("rcMeshGeo3", "(",
             new OneOperator4_<bool, string*, string*, string*, KN_<double>>(mesh_volumes));
}

} // namespace burnish
