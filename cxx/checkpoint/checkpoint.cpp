#include "checkpoint/checkpoint.hpp"
#include "base/archive.hpp"
#include "base/error.hpp"
#include "base/file_error.hpp"
#include "base/version.hpp"
#include "base/whole_file.hpp"
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>
#include <zlib.h>

namespace burnish {

template <class Archive> void serialize(Archive& archive, IdentityPart& value) {
  BURNISH_MEMBERS(value, name, words);
}
template <class Archive> void serialize(Archive& archive, GrowingFile& value) {
  BURNISH_MEMBERS(value, path, size);
}
template <class Archive> void serialize(Archive& archive, KeptValue& value) {
  BURNISH_MEMBERS(value, name, type, bytes);
}
template <class Archive> void serialize(Archive& archive, Checkpoint& value) {
  BURNISH_MEMBERS(value, t, t_end, identity, state, mesh, script_mesh, solver, files, values);
}

namespace {

namespace fs = std::filesystem;

constexpr char MAGIC[8] = {'B', 'u', 'r', 'n', 'i', 's', 'h', '\n'};
constexpr std::uint32_t FORMAT = 4, BYTE_ORDER_MARK = 0x01020304, TURNED_MARK = 0x04030201;

// Before the archive; plain numbers, so that another program can tell what it reads.
struct Head {
  char magic[8] = {};
  std::uint32_t byte_order = BYTE_ORDER_MARK, format = FORMAT;
  char version[16] = {};
  std::uint64_t size = 0; // of the archive [bytes]
  std::uint64_t checksum = 0;
};

std::uint64_t checksum_of(const std::string& bytes) {
  return crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
}

[[noreturn]] void not_written(const std::string& path, int reason) {
  throw FileError("checkpoint \"" + path + "\" cannot be written: " + std::strerror(reason));
}

// The new content of path beside it, on the disk when this returns.
void write_and_sync(const std::string& path, const Head& head, const std::string& bytes) {
  const std::string written = new_name(path);
  std::FILE* file = std::fopen(written.c_str(), "wb");
  if (!file) not_written(path, errno);
  bool ok = std::fwrite(&head, sizeof head, 1, file) == 1 &&
            std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  ok = ok && std::fflush(file) == 0 && fsync(fileno(file)) == 0;
  int reason = ok ? 0 : errno;
  if (std::fclose(file) != 0 && ok) reason = errno;
  if (reason == 0) return;
  std::remove(written.c_str());
  not_written(path, reason);
}

void sync(const std::string& path) {
  const int handle = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (handle < 0) return;
  fsync(handle);
  close(handle);
}

std::string folder_of(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  fail_at("checkpoint \"" + path + "\"", what);
}

Head read_head(std::istream& file, const std::string& path) {
  Head head;
  file.read(reinterpret_cast<char*>(&head), sizeof head);
  if (file.gcount() < static_cast<std::streamsize>(sizeof MAGIC) ||
      std::memcmp(head.magic, MAGIC, sizeof MAGIC) != 0)
    refuse(path, "is no checkpoint of Burnish");
  if (file.gcount() < static_cast<std::streamsize>(sizeof head)) refuse(path, "is cut off in its head");
  if (head.byte_order == TURNED_MARK)
    refuse(path, "was written on a machine of another byte order, expected one of this machine's");
  if (head.byte_order != BYTE_ORDER_MARK) refuse(path, "is damaged in its head");
  require(head.format == FORMAT, ("checkpoint \"" + path + "\"").c_str(), "format", head.format,
          std::to_string(FORMAT).c_str());
  const std::string version(head.version, strnlen(head.version, sizeof head.version));
  require(version == BURNISH_VERSION, ("checkpoint \"" + path + "\"").c_str(), "version of Burnish", version,
          BURNISH_VERSION);
  return head;
}

Checkpoint read_one(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(path, std::string("cannot be read: ") + std::strerror(errno));
  const Head head = read_head(file, path);
  std::error_code code;
  const std::uint64_t there = fs::file_size(path, code) - sizeof head;
  if (code || there != head.size)
    refuse(path, "has " + std::to_string(there) + " bytes behind its head, expected " +
                     std::to_string(head.size) + ": it is " + (there < head.size ? "cut off" : "damaged"));
  std::string bytes(head.size, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file || checksum_of(bytes) != head.checksum) refuse(path, "is damaged: its checksum is wrong");
  std::istringstream stream(bytes, std::ios::binary);
  Checkpoint checkpoint;
  try {
    Reader archive(stream);
    archive(checkpoint);
  } catch (const cereal::Exception& error) {
    refuse(path, std::string("is damaged: ") + error.what());
  }
  return checkpoint;
}

} // namespace

void write_checkpoint(const std::string& path, const Checkpoint& checkpoint) {
  std::ostringstream stream(std::ios::binary);
  {
    Writer archive(stream);
    archive(checkpoint);
  }
  const std::string bytes = stream.str(), written = new_name(path), older = path + OLDER;
  Head head;
  std::memcpy(head.magic, MAGIC, sizeof MAGIC);
  std::strncpy(head.version, BURNISH_VERSION, sizeof head.version - 1);
  head.size = bytes.size();
  head.checksum = checksum_of(bytes);
  write_and_sync(path, head, bytes);
  std::error_code code;
  if (fs::exists(path, code)) {
    fs::remove(older, code);
    fs::create_hard_link(path, older, code); // so that path is never without one, ...
    if (code) fs::rename(path, older, code); // ... where the disk knows such links
  }
  fs::rename(written, path, code);
  if (code) {
    const int reason = code.value();
    fs::remove(written, code);
    not_written(path, reason);
  }
  sync(folder_of(path));
}

Checkpoint read_checkpoint(const std::string& path) {
  std::error_code code;
  const std::string older = path + OLDER;
  if (!fs::exists(path, code) && fs::exists(older, code)) return read_one(older);
  try {
    return read_one(path);
  } catch (const ArgumentError& error) {
    std::string whole;
    try {
      std::ostringstream text;
      text << "; the one before it, \"" << older << "\", of t = " << read_one(older).t
           << ", is whole: -resume 2 goes on from it";
      whole = text.str();
    } catch (const std::invalid_argument&) {
    }
    throw ArgumentError(error.what() + whole);
  }
}

} // namespace burnish
