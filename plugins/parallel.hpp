#pragma once
// A script that runs on several processes, burnish -np N.

namespace burnish {

/// In FreeFem++-mpi with more than one process: these become the ranks of the core; all but rank 0 are silent and write no file.
/// To be called first when the plugin is loaded.
void join_ranks();

} // namespace burnish
