#include "kinematics/coordinates.hpp"
#include "base/error.hpp"
#include <cmath>

namespace burnish {

std::string joined(const std::vector<std::string>& names) {
  std::string list;
  for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

void require_coordinates(const std::string& where, const std::vector<std::string>& names,
                         const Eigen::VectorXd& q) {
  const auto size = static_cast<Eigen::Index>(names.size());
  if (q.size() != size) {
    const std::string expected = std::to_string(size) + " (" + joined(names) + ")";
    require(false, where.c_str(), "size of q", q.size(), expected.c_str());
  }
  for (Eigen::Index k = 0; k < size; ++k)
    require(std::isfinite(q(k)), where.c_str(), names[static_cast<std::size_t>(k)].c_str(), q(k),
            "a finite number");
}

} // namespace burnish
