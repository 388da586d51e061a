#include "cad/companion_gmsh/session.hpp"
#include <gmsh.h>
#include <vector>

namespace burnish_gmsh {
namespace {

bool begins_with(const std::string& text, const char* word) { return text.rfind(word, 0) == 0; }

std::vector<std::string> log_lines() {
  std::vector<std::string> log;
  gmsh::logger::get(log);
  return log;
}

} // namespace

void start(bool prints) {
  gmsh::initialize(0, nullptr, false); // no files of the user's options
  gmsh::option::setNumber("General.Terminal", prints);
  // an error thrown out of the parser would hide those that follow
  gmsh::option::setNumber("General.AbortOnError", 0);
  gmsh::model::add("burnish");
  gmsh::logger::start();
}

std::string first_error() {
  const std::string mark = "Error: ";
  for (const std::string& line : log_lines())
    if (line.compare(0, mark.size(), mark) == 0) return line.substr(mark.size());
  return "";
}

std::string last_lines() {
  std::vector<std::string> lines = log_lines(), bad;
  for (const std::string& line : lines)
    if (begins_with(line, "Error") || begins_with(line, "Warning")) bad.push_back(line);
  if (!bad.empty()) lines = bad;
  std::string text;
  for (std::size_t i = lines.size() > 6 ? lines.size() - 6 : 0; i < lines.size(); ++i)
    text += "\n  " + lines[i];
  return text;
}

const char* told(const std::string& text) {
  static std::string kept;
  kept = text;
  return kept.empty() ? nullptr : kept.c_str();
}

} // namespace burnish_gmsh
