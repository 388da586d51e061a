#pragma once
// The folder that a run writes to: its own while the process lives, without the results of an older run.
#include <string>

namespace burnish {

/// Makes a folder and what it is in, locks it until this process ends, however it ends, checks that files can be made there, and
/// removes new_names that an earlier run left. Follows no link and touches no other file. A file system that knows no locks has none.
/// @throws std::invalid_argument "where: ..." naming the reason, another process that has it too
void make_run_folder(const std::string& path, const char* where);
/// Removes what a run writes: tables, fields, report, movie, and pictures that bear our mark; not summary.json, nor files of the script.
void remove_results(const std::string& folder);
/// Removes the frames of a series behind the last one: fields-N.vtu, tools-N.vtp, surface-N.vtp with N > last.
void remove_frames(const std::string& folder, long last);

} // namespace burnish
