#pragma once
// OpenCASCADE as a guest: whatever it changes in the process is put back at the end of each visit.
#include <Message_SequenceOfPrinters.hxx>
#include <csignal>
#include <fenv.h>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace burnish {

/// While one lives: signals of bad memory become exceptions of OpenCASCADE (damaged STEP files make it use null
/// pointers), numbers are read in the C locale, and what it prints is caught. Afterwards signal handlers,
/// floating point environment, locale, streams and OpenCASCADE's printers are as before.
class OccGuard {
public:
  OccGuard();
  ~OccGuard();
  OccGuard(const OccGuard&) = delete;
  OccGuard& operator=(const OccGuard&) = delete;

  /// Runs f, which must own nothing but what OpenCASCADE made: a signal leaps over destructors.
  /// @return "" or what went wrong: the text of an exception or a signal
  std::string run(const std::function<void()>& f) const;
  /// What was printed, in one line.
  std::string printed() const;

private:
  std::vector<struct sigaction> m_signals;
  fenv_t m_floating;
  std::string m_locale;
  Message_SequenceOfPrinters m_printers;
  std::ostringstream m_printed;
  std::streambuf *m_cout, *m_cerr;
};

} // namespace burnish
