#pragma once
// A checkpoint in memory, for a run that is given up in the middle of a step.
#include "checkpoint/checkpoint.hpp"
#include <optional>

namespace burnish {

/// The last state of a run whose making was worth its time. Times are those of one clock [s].
class StandbyCheckpoint {
public:
  /// Whether the next one is: what has passed since the last one is PATIENCE_PER_COST times what that took.
  bool due(double now) const { return !m_kept_before || now - m_kept >= PATIENCE_PER_COST * m_took; }
  /// @param took seconds that it took to make
  void keep(Checkpoint checkpoint, double now, double took);
  /// nullptr: none since the last clear
  const Checkpoint* get() const { return m_checkpoint ? &*m_checkpoint : nullptr; }
  /// What it holds is on the disk, or a newer one is.
  void clear() { m_checkpoint.reset(); }

private:
  static constexpr double PATIENCE_PER_COST = 200; // at most 0.5 % of a run
  std::optional<Checkpoint> m_checkpoint;
  bool m_kept_before = false;
  double m_kept = 0, m_took = 0;
};

} // namespace burnish
