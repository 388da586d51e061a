#pragma once
// CHOLMOD's settings and workspace, owned. Only for the .cpp files of this folder.
#include <cstdint>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>
#include <suitesparse/cholmod.h>
#include <sys/mman.h>

namespace burnish {

/// From now on SuiteSparse's blocks of 32 MB and more have pages of 2 MB where Linux has them: those of 4 kB of a new
/// factor of 2 GB, and the search for them, took 12 % of a run's time.
inline void take_large_pages() {
#ifdef MADV_HUGEPAGE
  SuiteSparse_config.malloc_func = [](std::size_t bytes) {
    constexpr std::size_t large = 32 << 20, page = 2 << 20;
    void* const block = std::malloc(bytes);
    if (!block || bytes < large) return block;
    const auto begin = (reinterpret_cast<std::uintptr_t>(block) + page - 1) / page * page;
    const auto end = (reinterpret_cast<std::uintptr_t>(block) + bytes) / page * page;
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
    return block;
  };
#endif
}

/// A silent cholmod_common: nothing is printed, check() turns CHOLMOD's errors into exceptions.
class CholmodCommon {
public:
  CholmodCommon() {
    cholmod_start(&m_common);
    m_common.print = 0;
    m_common.error_handler = nullptr;
    m_common.nmethods = 1;
  }
  ~CholmodCommon() { cholmod_finish(&m_common); }
  CholmodCommon(const CholmodCommon&) = delete;
  CholmodCommon& operator=(const CholmodCommon&) = delete;

  cholmod_common* operator->() { return &m_common; }
  cholmod_common* get() { return &m_common; }

  /// @throws std::bad_alloc if memory ran out, std::runtime_error on any other CHOLMOD error. Warnings
  /// (CHOLMOD_NOT_POSDEF is one) pass.
  void check(const char* where) const {
    if (m_common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
    if (m_common.status == CHOLMOD_TOO_LARGE)
      throw std::runtime_error(
          std::string(where) +
          ": the factor has more than 2^31 numbers, too large for CHOLMOD; take a coarser mesh");
    if (m_common.status < 0)
      throw std::runtime_error(std::string(where) + ": CHOLMOD status " + std::to_string(m_common.status));
  }

private:
  cholmod_common m_common;
};

} // namespace burnish
