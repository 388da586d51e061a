#pragma once
// A run on disk: all that it needs to go on to the same bits, what it belongs to, and how far its files had grown.
#include <cstdint>
#include <string>
#include <vector>

namespace burnish {

/// Something that must be the same for a run to go on: "mesh", "option -mu"; its value in words.
struct IdentityPart {
  std::string name, value;
};

/// A file that grows line by line beside the run.
struct GrowingFile {
  std::string path;       ///< relative to the folder of the checkpoint, or absolute
  std::uint64_t size = 0; ///< at the checkpoint [bytes]
};

/// A variable of the script.
struct KeptValue {
  std::string name, type, bytes;
};

/// Plain data.
struct Checkpoint {
  double t = 0, t_end = 0; ///< instant of the state, end of the program [time]
  std::vector<IdentityPart> identity;
  std::string state;       ///< RunState, packed
  std::string mesh;        ///< StoredMesh, packed; "": that which the run began on
  std::string script_mesh; ///< the same as the script's program keeps meshes; "": as mesh
  std::string solver;      ///< the script's that keeps the factors; "": the core's
  std::vector<GrowingFile> files;
  std::vector<KeptValue> values;
};

/// What follows the name of a checkpoint in that of the one before it.
constexpr const char* OLDER = ".old";

/// Writes it aside, waits until the disk has it, and moves it onto path; the one that was there becomes path + OLDER. At every
/// instant a whole one is at path, if there was one before.
/// @throws FileError naming path and reason; what was there is kept
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint);

/// @throws std::invalid_argument "path: ..." if there is none, or it is damaged, short, of another version or byte order; names
///         the older one, where that is whole
Checkpoint read_checkpoint(const std::string& path);

/// @throws std::invalid_argument "path: ..." naming every part that differs
void require_same(const std::string& path, const std::vector<IdentityPart>& then,
                  const std::vector<IdentityPart>& now);

/// Sizes of files as they are on the disk now, which has all of them then. Files that are gone are left out.
/// @param folder of the checkpoint
std::vector<GrowingFile> growing_files(const std::vector<std::string>& paths, const std::string& folder);
/// Their paths as a script names them.
std::vector<std::string> present_paths(const std::vector<GrowingFile>& files, const std::string& folder);
/// Cuts the files to their sizes at the checkpoint: what came later will be written again.
/// @throws std::invalid_argument if one is gone or shorter, with nothing cut
/// @returns their paths as a script names them
std::vector<std::string> cut_files(const std::vector<GrowingFile>& files, const std::string& folder);

} // namespace burnish
