#pragma once
// Names of the checkpoints of a script's runs, one after the other in one folder.
#include <string>
#include <vector>

namespace burnish {

/// run-NUMBER.checkpoint in folder
std::string run_file(const std::string& folder, long number);
/// The checkpoints, and those before them, of the runs that come after that of path, a run_file. Empty for other names.
std::vector<std::string> later_run_files(const std::string& path);

} // namespace burnish
