#include "checkpoint/run_files.hpp"
#include <filesystem>
#include <regex>

namespace burnish {
namespace {

namespace fs = std::filesystem;

// 0: no file of a run
long run_number(const fs::path& path) {
  static const std::regex name("run-(\\d{1,9})\\.checkpoint(\\.old)?");
  std::smatch found;
  const std::string text = path.filename().string();
  return std::regex_match(text, found, name) ? std::stol(found[1]) : 0;
}

} // namespace

std::string run_file(const std::string& folder, long number) {
  return (fs::path(folder) / ("run-" + std::to_string(number) + ".checkpoint")).string();
}

std::vector<std::string> later_run_files(const std::string& path) {
  std::vector<std::string> later;
  const long number = run_number(path);
  const fs::path folder = fs::path(path).parent_path();
  std::error_code code;
  if (number > 0)
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.empty() ? "." : folder, code))
      if (run_number(entry.path()) > number) later.push_back(entry.path().string());
  return later;
}

} // namespace burnish
