// What all other times are divided by, in the same run: the numerical factorization of one fixed matrix by CHOLMOD alone, none of our
// code. Two degrees of freedom a node of a square grid of 120 x 120 nodes, nine neighbors, 28 800 unknowns.
#include <benchmark/benchmark.h>
#include <cstdlib>
#include <suitesparse/cholmod.h>
#include <vector>

namespace {

constexpr int SIDE = 120;

struct Matrix {
  cholmod_common common;
  cholmod_sparse* A = nullptr;
  cholmod_factor* L = nullptr;
  Matrix() {
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_AMD;
    const int n = 2 * SIDE * SIDE;
    cholmod_triplet* T =
        cholmod_allocate_triplet(n, n, 18 * static_cast<std::size_t>(n), -1, CHOLMOD_REAL, &common);
    for (int a = 0; a < SIDE * SIDE; ++a)
      for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy) add_pair(T, a, dx, dy);
    A = cholmod_triplet_to_sparse(T, 0, &common);
    cholmod_free_triplet(&T, &common);
    L = cholmod_analyze(A, &common);
    if (!L || common.status != CHOLMOD_OK) std::abort();
  }
  // Couplings of a node with itself or a neighbor, lower triangle, diagonally dominant.
  static void add_pair(cholmod_triplet* T, int a, int dx, int dy) {
    const int x = a % SIDE + dx, y = a / SIDE + dy;
    if (x < 0 || y < 0 || x >= SIDE || y >= SIDE) return;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        const int row = 2 * a + i, column = 2 * (x + SIDE * y) + j;
        if (column > row) continue;
        static_cast<int*>(T->i)[T->nnz] = row;
        static_cast<int*>(T->j)[T->nnz] = column;
        static_cast<double*>(T->x)[T->nnz] = row == column ? 20 : -1;
        ++T->nnz;
      }
  }
  ~Matrix() {
    cholmod_free_factor(&L, &common);
    cholmod_free_sparse(&A, &common);
    cholmod_finish(&common);
  }
  Matrix(const Matrix&) = delete;
  Matrix& operator=(const Matrix&) = delete;
};

void yardstick(benchmark::State& state) {
  Matrix matrix;
  for (auto _ : state)
    if (!cholmod_factorize(matrix.A, matrix.L, &matrix.common)) state.SkipWithError("not factorized");
}

} // namespace

BENCHMARK(yardstick)->Unit(benchmark::kMillisecond);
