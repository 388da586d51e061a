#pragma once
// gmsh as a guest: whatever it changes in the process is put back at the end of each visit.
#include <iosfwd>
#include <memory>
#include <sstream>
#include <string>

namespace burnish {

/// While one lives: gmsh is quiet and collects its errors (an error thrown out of its parser would leave
/// the rest of a file to the next one), numbers are read in the C locale, std::cout and std::cerr are caught
/// (OpenCASCADE prints). Afterwards locale, streams, options and current model are as before.
class GmshSession {
public:
  /// @param model  becomes the current one; empty: none
  explicit GmshSession(const std::string& model = "");
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

  /// Adds a model under a name of its own and makes it current. Returns the name.
  std::string new_model() const;
  /// Reads a file into the current model. Returns the first error that gmsh tells, "" if all went well.
  std::string merge(const std::string& path) const;
  /// What was printed on std::cout and std::cerr since the last merge.
  std::string printed() const { return m_printed.str(); }
  void remove(const std::string& model) const;

private:
  std::string m_locale, m_current;
  double m_terminal = 0, m_abort = 0;
  mutable std::ostringstream m_printed;
  std::streambuf *m_cout, *m_cerr;
};

/// A file in the system's folder for such, removed at the end.
class TemporaryFile {
public:
  TemporaryFile(const std::string& text, const std::string& extension);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return m_path; }

private:
  std::string m_path;
};

} // namespace burnish
