// burnish -np N SCRIPT: the script runs on N processes of FreeFem++-mpi, which take the same decisions. Element work, factors and
// solves of large bodies are divided among them, the rest each one does for itself. Process 0 alone prints, draws and writes files,
// those that the script opens by ofstream, too; other files of FreeFEM (savemesh, savevtk, exec) are written by all: call them if
// (mpirank == 0), which FreeFem++-mpi knows.
#include "parallel.hpp"
#include "parallel/ranks.hpp"
#include "plugin.hpp"
#include <dlfcn.h>
#include <fcntl.h>
#include <fstream>
#include <unistd.h>

namespace burnish {
namespace {

constexpr const char* NOWHERE = "/dev/null";

// Numbers of FreeFem++-mpi; plain FreeFem++ has them, too, or not.
long number_of(const char* name, long otherwise) {
  const void* const found = dlsym(RTLD_DEFAULT, name);
  return found ? *static_cast<const long*>(found) : otherwise;
}

// FreeFem++-mpi ends MPI before the process ends; Ranks::leave does it.
void keep_mpi() {
  using Finalize = void (*)();
  auto* const finalize = static_cast<Finalize*>(dlsym(RTLD_DEFAULT, "_ZN5ffapi12mpi_finalizeE"));
  if (finalize) *finalize = [] {};
}

// ofstream f(name), f(name, append) of the script
std::ostream** open_nowhere(std::ostream** const& stream, string* const&) {
  *stream = new std::ofstream(NOWHERE);
  return stream;
}
std::ostream** append_nowhere(std::ostream** const& stream, string* const&,
                              const std::ios::openmode& /*mode*/) {
  *stream = new std::ofstream(NOWHERE);
  return stream;
}

void be_silent() {
  const int nowhere = open(NOWHERE, O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  close(nowhere);
  constexpr int first = 1; // before FreeFEM's own
  TheOperators->Add(
      "<-", new OneOperator2_<std::ostream**, std::ostream**, string*>(first, open_nowhere),
      new OneOperator3_<std::ostream**, std::ostream**, string*, std::ios::openmode>(first, append_nowhere));
}

} // namespace

void join_ranks() {
  if (number_of("mpisize", 1) < 2) return;
  guarded([] { set_ranks(mpi_ranks([] { return latest_error(); })); });
  keep_mpi();
  if (ranks().rank() > 0) be_silent();
}

} // namespace burnish
