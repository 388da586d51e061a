# Read first by the tests in tests/mpi: they pass over, with a word, where burnish -np cannot run.
set -u
if ! [ -f "$BUILD/plugins/burnish_mpi.so" ] || ! command -v mpirun >/dev/null || ! command -v FreeFem++-mpi >/dev/null; then
  echo "skipped: no burnish_mpi.so, mpirun or FreeFem++-mpi here (make test-mpi installs libmumps-dev and libopenmpi-dev)"
  exit 0
fi
failures=0
report() { echo "FAILED: $*"; failures=$((failures + 1)); }
plane=(tests/support/mpi-plane.edp -pictures 0 -series 2 -check 0)
