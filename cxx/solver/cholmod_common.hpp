#pragma once
// CHOLMOD's settings and workspace, owned. Only for the .cpp files of this folder.
#include <new>
#include <stdexcept>
#include <string>
#include <suitesparse/cholmod.h>

namespace burnish {

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
