#pragma once
// CPU seconds of this process, added up by phase.
#include <ctime>

namespace burnish {

/// Adds the CPU time between construction and destruction to a sum [s].
class CpuTimer {
public:
  explicit CpuTimer(double& sum) : m_sum(sum), m_start(std::clock()) {}
  ~CpuTimer() { m_sum += static_cast<double>(std::clock() - m_start) / CLOCKS_PER_SEC; }
  CpuTimer(const CpuTimer&) = delete;
  CpuTimer& operator=(const CpuTimer&) = delete;

private:
  double& m_sum;
  std::clock_t m_start;
};

} // namespace burnish
