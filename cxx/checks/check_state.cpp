#include "checks/check_state.hpp"
#include <algorithm>

namespace burnish {

void CheckState::largest(const std::string& name, double value) {
  const auto entry = measured.emplace(name, value).first;
  entry->second = std::max(entry->second, value);
}

void CheckState::smallest(const std::string& name, double value) {
  const auto entry = measured.emplace(name, value).first;
  entry->second = std::min(entry->second, value);
}

} // namespace burnish
