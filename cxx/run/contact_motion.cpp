#include "run/contact_motion.hpp"
#include "contact/slip_motion.hpp"
#include "iteration/contact_window.hpp"
#include <algorithm>

namespace burnish {

template <int Dim> double contact_width(const ContactRun<Dim>& run) {
  double width = 0;
  for (int t = 0; t < static_cast<int>(run.setup().tools().size()); ++t)
    width = std::max(width, contact_width(run.setup().model(), run.setup().body(), run.accepted().contact,
                                          run.accepted().u, t, run.accepted().history.q_old));
  return width;
}

template <int Dim> double contact_speed(const ContactRun<Dim>& run) {
  const StepHistory<Dim>& history = run.accepted().history;
  if (history.dt == 0) return 0;
  return contact_speed(run.setup().model(), run.accepted().contact, history.q_old, history.dt);
}

template <int Dim> std::vector<std::string> left_out(const ContactRun<Dim>& run) {
  std::vector<std::string> names = run.accepted().left_out;
  for (const std::string& name : run.step().left_out)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template double contact_width<Dim>(const ContactRun<Dim>&);                                                \
  template double contact_speed<Dim>(const ContactRun<Dim>&);                                                \
  template std::vector<std::string> left_out<Dim>(const ContactRun<Dim>&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
