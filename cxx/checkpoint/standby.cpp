#include "checkpoint/standby.hpp"
#include <utility>

namespace burnish {

void StandbyCheckpoint::keep(Checkpoint checkpoint, double now, double took) {
  m_checkpoint = std::move(checkpoint);
  m_kept_before = true;
  m_kept = now;
  m_took = took;
}

} // namespace burnish
