#include "kinematics/surface_mesh.hpp"
#include "base/error.hpp"

namespace burnish {
namespace {

void require_window(const Eigen::AlignedBox3d& window) {
  constexpr const char* where = "surface_mesh";
  require(window.min().allFinite(), where, "corner of the window", window.min().transpose(),
          "finite components");
  require(window.max().allFinite(), where, "corner of the window", window.max().transpose(),
          "finite components");
  require(!window.isEmpty() && window.sizes().maxCoeff() > 0, where, "sizes of the window",
          window.sizes().transpose(), "none negative, one > 0");
}

} // namespace

SurfaceMesh surface_mesh(const Surface<3>& surface, const Eigen::AlignedBox3d& window) {
  require_window(window);
  return surface.mesh(window);
}

SurfaceMesh surface_mesh(const Tool<3>& tool, const Eigen::VectorXd& q, const Eigen::AlignedBox3d& window) {
  require_window(window);
  const Pose<3> pose = tool.coordinates().pose(q);
  Eigen::AlignedBox3d local; // about the corners of the window
  for (int corner = 0; corner < 8; ++corner)
    local.extend(Vector<3>(
        pose.R.transpose() *
        (window.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)) - pose.origin) / pose.size));
  SurfaceMesh mesh = surface_mesh(tool.surface(), local);
  for (auto& point : mesh.points) point = pose.origin + pose.R * (pose.size * point);
  return mesh;
}

} // namespace burnish
