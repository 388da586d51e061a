#include "solver/required_memory.hpp"
#include "base/error.hpp"
#include "base/memory_limit.hpp"

namespace burnish {

void require_memory(const char* where, const std::string& what, double bytes) {
  if (bytes <= memory_left()) return;
  std::ostringstream message;
  message << what << std::fixed << std::setprecision(2) << " " << bytes / 1e9 << " GB, and "
          << memory_left_in_words();
  fail(where, message.str());
}

} // namespace burnish
