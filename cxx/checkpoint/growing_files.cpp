// The files beside a checkpoint, which grow as the run goes on.
#include "base/error.hpp"
#include "checkpoint/checkpoint.hpp"
#include "parallel/first_rank.hpp"
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

namespace burnish {
namespace {

namespace fs = std::filesystem;

// Within the folder of the checkpoint relative to it, so that the folder may be moved.
std::string kept_path(const std::string& path, const std::string& folder) {
  const fs::path whole = fs::weakly_canonical(path);
  const fs::path from = whole.lexically_relative(fs::weakly_canonical(folder));
  const bool inside = !from.empty() && *from.begin() != "..";
  return (inside ? from : whole).string();
}

std::string present_path(const std::string& kept, const std::string& folder) {
  const fs::path path(kept);
  return (path.is_absolute() ? path : fs::path(folder) / path).string();
}

void require_whole(const std::string& path, std::uintmax_t wanted) {
  std::error_code code;
  const std::uintmax_t size = fs::file_size(path, code);
  if (code) fail_at("file \"" + path + "\"", "cannot go on: " + code.message());
  if (size < wanted)
    fail_at("file \"" + path + "\"", "has " + std::to_string(size) + " bytes, expected the " +
                                         std::to_string(wanted) +
                                         " that it had at the checkpoint: it is of another run");
}

} // namespace

std::vector<GrowingFile> growing_files(const std::vector<std::string>& paths, const std::string& folder) {
  std::vector<GrowingFile> files;
  for (const std::string& path : paths) {
    const int handle = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (handle < 0) continue;
    fsync(handle);
    const off_t size = lseek(handle, 0, SEEK_END);
    close(handle);
    if (size >= 0) files.push_back({kept_path(path, folder), static_cast<std::uint64_t>(size)});
  }
  return files;
}

std::vector<std::string> present_paths(const std::vector<GrowingFile>& files, const std::string& folder) {
  std::vector<std::string> paths;
  for (const GrowingFile& file : files) paths.push_back(present_path(file.path, folder));
  return paths;
}

std::vector<std::string> cut_files(const std::vector<GrowingFile>& files, const std::string& folder) {
  std::vector<std::string> paths = present_paths(files, folder);
  on_first_rank([&] {
    for (std::size_t i = 0; i < files.size(); ++i) require_whole(paths[i], files[i].size);
    for (std::size_t i = 0; i < files.size(); ++i) fs::resize_file(paths[i], files[i].size);
  });
  return paths;
}

} // namespace burnish
