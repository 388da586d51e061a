#pragma once
// Tools of the plane made from profiles, and their places by the profile's parameter.
#include "geometry/profile_surface.hpp"
#include "kinematics/driven_tool.hpp"

namespace burnish::test {

inline std::shared_ptr<const Tool<2>> profile_tool(const std::string& name,
                                                   std::shared_ptr<const Profile<2>> profile,
                                                   std::shared_ptr<const Coordinates<2>> coordinates) {
  return std::make_shared<Tool<2>>(name, std::make_shared<ProfileSurface>(std::move(profile)),
                                   std::move(coordinates));
}

/// A tool that a script would hold.
inline std::shared_ptr<DrivenTool<2>> driven_tool(const std::string& name,
                                                  std::shared_ptr<const Profile<2>> profile,
                                                  std::shared_ptr<const Coordinates<2>> coordinates) {
  auto tool = std::make_shared<DrivenTool<2>>(name, std::make_shared<ProfileSurface>(std::move(profile)));
  tool->set_coordinates(std::move(coordinates));
  return tool;
}

inline const ProfileSurface& profile_surface(const Tool<2>& tool) {
  return dynamic_cast<const ProfileSurface&>(tool.surface());
}
/// Place of the parameter s on the profile of a tool.
inline SurfacePlace<2> place_of(const Tool<2>& tool, double s) { return profile_surface(tool).at(s); }

} // namespace burnish::test
