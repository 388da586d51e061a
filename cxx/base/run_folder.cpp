#include "base/run_folder.hpp"
#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "parallel/first_rank.hpp"
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <stdlib.h>
#include <sys/file.h>
#include <unistd.h>

namespace burnish {

namespace fs = std::filesystem;

namespace {

const std::string PICTURE_MARK("Software\0Burnish", 16); // cases/plotting/figure.py
constexpr std::size_t PICTURE_HEAD = 4096;               // bytes of a picture in which it stands

/// The lock is on the folder itself, so that none is left over. Programs that this one starts do not inherit it.
void lock_folder(const std::string& path, const std::string& begin, const char* where) {
  static std::map<std::string, int> locked; // handles by path
  const std::string folder = fs::canonical(path).string();
  if (locked.count(folder)) return;
  const int handle = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle < 0) fail(where, begin + "cannot be read: " + std::strerror(errno));
  if (flock(handle, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(handle);
    fail(where,
         begin + "is in use: another run writes to it; wait for its end, or give another folder by -out");
  }
  locked[folder] = handle;
}

bool drawn_by_us(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(PICTURE_HEAD, ' ');
  file.read(head.data(), PICTURE_HEAD);
  return head.find(PICTURE_MARK) != std::string::npos;
}

void make_own_folder(const std::string& path, const char* where) {
  const std::string begin = "the output folder \"" + path + "\" ";
  std::error_code code;
  fs::create_directories(path, code);
  if (code && !fs::is_directory(path)) fail(where, begin + "cannot be written: " + code.message());
  lock_folder(path, begin, where);
  std::string probe = path + "/.writableXXXXXX";
  const int handle = mkstemp(probe.data());
  if (handle < 0) fail(where, begin + "cannot be written: " + std::strerror(errno));
  close(handle);
  unlink(probe.c_str());
  for (const auto& entry : fs::directory_iterator(path, code))
    if (entry.path().filename().string().rfind(NEW_MARK, 0) == 0) fs::remove(entry.path(), code);
}

void remove_all_results(const std::string& folder) {
  static const std::regex results(
      "(history|events|surface|tools|model)\\.csv|final\\.vtu|fields\\.pvd|supports\\.vtp|report\\.txt|"
      "movie\\.(html|gif)|fields-[0-9]+\\.vtu|(tools|surface)-[0-9]+\\.vtp");
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    if (fs::is_directory(entry.symlink_status())) continue;
    const bool result = std::regex_match(entry.path().filename().string(), results) ||
                        (entry.path().extension() == ".png" && drawn_by_us(entry.path()));
    if (result) fs::remove(entry.path(), code);
  }
}

void remove_later_frames(const std::string& folder, long last) {
  static const std::regex frame("(?:fields|tools|surface)-([0-9]{1,9})\\.vt[up]");
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    const std::string name = entry.path().filename().string();
    std::smatch number;
    if (std::regex_match(name, number, frame) && std::stol(number[1]) > last) fs::remove(entry.path(), code);
  }
}

} // namespace

void make_run_folder(const std::string& path, const char* where) {
  on_first_rank([&] { make_own_folder(path, where); });
}
void remove_results(const std::string& folder) {
  on_first_rank([&] { remove_all_results(folder); });
}
void remove_frames(const std::string& folder, long last) {
  on_first_rank([&] { remove_later_frames(folder, last); });
}

} // namespace burnish
