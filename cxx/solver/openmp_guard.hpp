#pragma once
// CHOLMOD's supernodal code opens four OpenMP threads for loops of microseconds, whatever the number of
// cores; without them the factorization of 8600 unknowns takes 5 instead of 10 ms.

namespace burnish {

/// While it lives, OpenMP regions of this thread run on one thread: without a team where burnish_openmp.so is loaded, else by the limit of
/// nested regions. Does nothing without an OpenMP run time, or if OpenBLAS itself is built on OpenMP and would lose its threads.
class OpenmpGuard {
public:
  OpenmpGuard();
  ~OpenmpGuard();
  OpenmpGuard(const OpenmpGuard&) = delete;
  OpenmpGuard& operator=(const OpenmpGuard&) = delete;

private:
  int m_levels = -1;     ///< nesting limit to restore, -1: none
  bool m_serial = false; ///< to restore in burnish_openmp.so
};

} // namespace burnish

/// Of burnish_openmp.so: whether regions of this thread shall be plain calls; @returns what held before.
extern "C" bool burnish_serial_regions(bool wanted);
