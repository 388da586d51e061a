#include "geometry/cad_session.hpp"
#include "base/error.hpp"
#include <clocale>
#include <filesystem>
#include <fstream>
#include <gmsh.h>
#include <iostream>
#include <stdlib.h>
#include <unistd.h>
#include <vector>

namespace burnish {

GmshSession::GmshSession(const std::string& model) : m_locale(std::setlocale(LC_ALL, nullptr)) {
  m_cout = std::cout.rdbuf(m_printed.rdbuf());
  m_cerr = std::cerr.rdbuf(m_printed.rdbuf());
  static const bool initialized = [] {
    gmsh::initialize(0, nullptr, false); // no files of the user's options
    gmsh::option::setNumber("General.Terminal", 0);
    return true;
  }();
  (void)initialized;
  std::setlocale(LC_ALL, m_locale.c_str());
  std::setlocale(LC_NUMERIC, "C");
  gmsh::option::getNumber("General.Terminal", m_terminal);
  gmsh::option::getNumber("General.AbortOnError", m_abort);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.AbortOnError", 0);
  gmsh::model::getCurrent(m_current);
  if (!model.empty() && model != m_current) gmsh::model::setCurrent(model);
}

GmshSession::~GmshSession() {
  std::string now;
  gmsh::model::getCurrent(now);
  std::vector<std::string> models;
  gmsh::model::list(models);
  for (const std::string& name : models)
    if (name == m_current && now != m_current) gmsh::model::setCurrent(m_current);
  gmsh::option::setNumber("General.AbortOnError", m_abort);
  gmsh::option::setNumber("General.Terminal", m_terminal);
  std::setlocale(LC_ALL, m_locale.c_str());
  std::cout.rdbuf(m_cout);
  std::cerr.rdbuf(m_cerr);
}

std::string GmshSession::new_model() const {
  static int count = 0;
  const std::string name = "burnish tool " + std::to_string(++count);
  gmsh::model::add(name);
  return name;
}

std::string GmshSession::merge(const std::string& path) const {
  gmsh::onelab::clear();
  gmsh::logger::start();
  m_printed.str("");
  gmsh::merge(path);
  std::vector<std::string> log;
  gmsh::logger::get(log);
  gmsh::logger::stop();
  gmsh::onelab::clear();
  const std::string mark = "Error: ";
  for (const std::string& line : log)
    if (line.compare(0, mark.size(), mark) == 0) return line.substr(mark.size());
  return "";
}

void GmshSession::remove(const std::string& model) const {
  gmsh::model::setCurrent(model);
  gmsh::model::remove();
}

TemporaryFile::TemporaryFile(const std::string& text, const std::string& extension)
    : m_path((std::filesystem::temp_directory_path() / ("burnishXXXXXX" + extension)).string()) {
  const int handle = mkstemps(m_path.data(), static_cast<int>(extension.size()));
  if (handle < 0) fail("CadFile", "no temporary file can be made in " + m_path);
  close(handle);
  std::ofstream(m_path) << text;
}

TemporaryFile::~TemporaryFile() {
  std::error_code code;
  std::filesystem::remove(m_path, code);
}

} // namespace burnish
