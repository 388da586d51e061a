#include "base/stop_request.hpp"
#include <utility>

namespace burnish {
namespace {

std::function<bool()>& stop_answer() {
  static std::function<bool()> answer;
  return answer;
}

} // namespace

bool stop_asked() { return stop_answer() && stop_answer()(); }

void set_stop_asked(std::function<bool()> answer) { stop_answer() = std::move(answer); }

} // namespace burnish
