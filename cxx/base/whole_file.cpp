#include "base/whole_file.hpp"
#include "parallel/first_rank.hpp"
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace burnish {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t PART = 4096; // bytes looked at from the end

std::string last_bytes(const std::string& path, std::uintmax_t from) {
  std::ifstream stream(path, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(from));
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// What a write said is gone; a byte more says it again.
std::string reason_of(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "a");
  if (!file) return std::strerror(errno);
  int reason = 0;
  const std::string block(PART, '\n');
  if (std::fwrite(block.data(), 1, block.size(), file) < block.size() || std::fflush(file) != 0)
    reason = errno;
  if (std::fclose(file) != 0 && reason == 0) reason = errno;
  return reason != 0 ? std::strerror(reason) : "the disk was full";
}

void put_in_place(const std::string& path, bool ok) {
  const std::string written = new_name(path);
  std::error_code code;
  if (ok) fs::rename(written, path, code);
  if (ok && !code) return;
  const std::string reason = code ? code.message() : reason_of(written);
  fs::remove(written, code);
  const bool older = fs::exists(path, code);
  throw FileError("file \"" + path + "\" cannot be written: " + reason +
                  (older ? "; the one before it is kept" : ""));
}

void cut_to_whole_lines(const std::string& path) {
  const std::string reason = reason_of(path);
  std::error_code code;
  std::uintmax_t size = fs::file_size(path, code), from = size;
  while (!code && from > 0) {
    from -= std::min(from, PART);
    // of the blocks of empty lines that asked for the reason nothing stays either
    const std::string part = last_bytes(path, from).substr(0, size - from);
    std::size_t end = part.find_last_of('\n');
    while (end != std::string::npos && end > 0 && part[end - 1] == '\n') --end;
    if (end == std::string::npos || (end == 0 && from > 0)) continue;
    fs::resize_file(path, from + end + 1, code);
    break;
  }
  throw FileError("file \"" + path + "\" cannot be written on: " + reason + "; its whole lines are kept");
}

} // namespace

std::string new_name(const std::string& path) {
  const fs::path whole(path);
  return (whole.parent_path() / (NEW_MARK + whole.filename().string())).string();
}

void replace_file(const std::string& path, bool ok) {
  on_first_rank([&] { put_in_place(path, ok); });
}

void write_whole(const std::string& path, const std::string& text) {
  on_first_rank([&] {
    std::ofstream file(new_name(path), std::ios::binary);
    file << text;
    file.close();
    put_in_place(path, file.good());
  });
}

void keep_whole_lines(const std::string& path, bool ok) {
  on_first_rank([&] {
    if (!ok) cut_to_whole_lines(path);
  });
}

bool ends_with(const std::string& path, const std::string& text) {
  std::error_code code;
  const std::uintmax_t size = fs::file_size(path, code);
  if (code || size < text.size()) return false;
  std::string last = last_bytes(path, size - std::min(size, PART));
  last.erase(last.find_last_not_of(" \t\r\n") + 1);
  return last.size() >= text.size() && last.compare(last.size() - text.size(), text.size(), text) == 0;
}

} // namespace burnish
