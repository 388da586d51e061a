#pragma once
// What the files of a script and its options say to the checkpoints of its runs.
#include <set>
#include <string>

namespace burnish {

/// Files to which the script has added lines.
std::set<std::string>& growing_paths();
/// Option -resume: 0, 1, 2.
long resume_option();
/// Lets a script that calls a run have -checkpoint and -resume, which it need not read.
void accept_checkpoint_options();

} // namespace burnish
