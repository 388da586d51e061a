#pragma once
// What the files of a script and its options say to the checkpoints of its runs.
#include <set>
#include <string>

namespace burnish {

/// Files to which the script has added lines.
std::set<std::string>& growing_paths();
/// Option -resume: 0, 1, 2.
long resume_option();
/// Reads -checkpoint and -resume, for the list of the options.
void read_checkpoint_options();
/// Words of the scripts that have these options.
constexpr const char* RUNNING_WORDS =
    "rcRun rcRunForms rcRunLaw rcCondensedRun rcCondensedRunLaw rcCase rcCaseForms rcCaseLaw";

} // namespace burnish
