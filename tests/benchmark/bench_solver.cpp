// Times of the solvers on a ring sector of P2 triangles: 4305 nodes (20 x 52 cells, 105 nodes on the outer
// arc), and 4221 nodes with 201 on the outer arc (10 x 100 cells). Reports, judges nothing.
#include "solver/blas_info.hpp"
#include "solver/bordered_solver.hpp"
#include "solver/schur_factor.hpp"
#include "solver/unsymmetric_solver.hpp"
#include "unit/solver/elastic_sample.hpp"
#include <benchmark/benchmark.h>

using namespace burnish;

namespace {

struct Body {
  NodeBlockMatrix<2> K;
  std::vector<char> fixed;
  std::vector<int> candidates;

  Body(int num_radial, int num_along) {
    const sample::Mesh<2> mesh = sample::with_mid_nodes(sample::ring_sector(num_radial, num_along));
    K = sample::stiffness(mesh, 0.);
    fixed = sample::fix(K, mesh.inner);
    candidates = mesh.outer;
  }
};

/// Clamped ring sector; the last argument is the number of candidates.
struct Schur : benchmark::Fixture {
  SchurFactor<2> factor;
  Body body{1, 1};
  void SetUp(const benchmark::State& state) override {
    set_blas_threads(1);
    body = Body(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    body.candidates.resize(state.range(2));
    factor.analyze(body.K, body.fixed, body.candidates);
    if (factor.factorize(body.K) != FactorStatus::OK) std::abort();
  }
  static void meshes(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgNames({"radial", "along", "candidates"})->Unit(benchmark::kMillisecond);
    for (int candidates : {0, 50, 105}) benchmark->Args({20, 52, candidates});
    benchmark->Args({10, 100, 201});
  }
};

/// The body in compressed rows; the last argument is the number of rows that friction spoils.
struct Contact : benchmark::Fixture {
  std::vector<int> row_start, col;
  std::vector<double> value;
  SparseView view;
  void SetUp(const benchmark::State& state) override {
    set_blas_threads(1);
    const Body body(20, 52);
    std::vector<char> has_friction(body.K.size(), 0);
    for (int k = 0; k < state.range(0); ++k) has_friction[2 * body.candidates[k]] = 1;
    row_start = {0};
    col.clear();
    value.clear();
    for (int i = 0; i < body.K.size(); ++i) {
      for (int k = body.K.row_start[i / 2]; k < body.K.row_start[i / 2 + 1]; ++k)
        for (int c = 0; c < 2; ++c) append(body, i, k, c, has_friction[i]);
      row_start.push_back(static_cast<int>(col.size()));
    }
    view = {body.K.size(), row_start.data(), col.data(), value.data(), false};
  }
  void append(const Body& body, int i, int k, int c, bool has_friction) {
    const int j = 2 * body.K.col[k] + c;
    if ((body.fixed[i] || body.fixed[j]) && i != j) return;
    const double* block = body.K.block(k);
    col.push_back(j);
    value.push_back(block[2 * (i % 2) + c] + (has_friction ? 0.2 * block[2 * (1 - i % 2) + c] : 0.));
  }
  static void rows(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgName("friction_rows")->Unit(benchmark::kMillisecond);
    for (int count : {0, 10, 50, 105}) benchmark->Arg(count);
  }
};

} // namespace

BENCHMARK_DEFINE_F(Schur, Analyze)(benchmark::State& state) {
  for (auto _ : state) {
    SchurFactor<2> fresh;
    fresh.analyze(body.K, body.fixed, body.candidates);
  }
}
BENCHMARK_REGISTER_F(Schur, Analyze)->Apply(Schur::meshes);

BENCHMARK_DEFINE_F(Schur, Factorize)(benchmark::State& state) {
  for (auto _ : state) {
    factor.analyze(body.K, body.fixed, body.candidates); // cached
    benchmark::DoNotOptimize(factor.factorize(body.K));
  }
}
BENCHMARK_REGISTER_F(Schur, Factorize)->Apply(Schur::meshes);

BENCHMARK_DEFINE_F(Schur, Solve)(benchmark::State& state) {
  const Eigen::VectorXd b = sample::random_vector(body.K.size());
  for (auto _ : state) benchmark::DoNotOptimize(factor.solve(b));
}
BENCHMARK_REGISTER_F(Schur, Solve)->Apply(Schur::meshes);

BENCHMARK_DEFINE_F(Schur, Flexibility)(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(factor.candidate_flexibility());
}
BENCHMARK_REGISTER_F(Schur, Flexibility)->Apply(Schur::meshes);

BENCHMARK_DEFINE_F(Contact, BorderedFactorize)(benchmark::State& state) {
  BorderedSolver solver;
  for (auto _ : state) benchmark::DoNotOptimize(solver.factorize(view));
}
BENCHMARK_REGISTER_F(Contact, BorderedFactorize)->Apply(Contact::rows);

BENCHMARK_DEFINE_F(Contact, BorderedSolve)(benchmark::State& state) {
  BorderedSolver solver;
  solver.factorize(view);
  const Eigen::VectorXd b = sample::random_vector(view.n);
  for (auto _ : state) benchmark::DoNotOptimize(solver.solve(b));
}
BENCHMARK_REGISTER_F(Contact, BorderedSolve)->Apply(Contact::rows);

BENCHMARK_DEFINE_F(Contact, UmfpackFactorize)(benchmark::State& state) {
  UnsymmetricSolver solver;
  for (auto _ : state) benchmark::DoNotOptimize(solver.factorize(view));
}
BENCHMARK_REGISTER_F(Contact, UmfpackFactorize)->Apply(Contact::rows);

BENCHMARK_DEFINE_F(Contact, UmfpackSolve)(benchmark::State& state) {
  UnsymmetricSolver solver;
  solver.factorize(view);
  const Eigen::VectorXd b = sample::random_vector(view.n);
  for (auto _ : state) benchmark::DoNotOptimize(solver.solve(b));
}
BENCHMARK_REGISTER_F(Contact, UmfpackSolve)->Apply(Contact::rows);

static void ReadTriplets(benchmark::State& state) {
  const Body body(20, 52);
  std::vector<int> row, col;
  std::vector<double> value;
  for (int node = 0; node < body.K.num_nodes; ++node)
    for (int k = body.K.row_start[node]; k < body.K.row_start[node + 1]; ++k)
      for (int e = 0; e < 4; ++e) {
        row.push_back(2 * node + e / 2);
        col.push_back(2 * body.K.col[k] + e % 2);
        value.push_back(body.K.block(k)[e]);
      }
  TripletReader<2> reader;
  const TripletView view{body.K.size(), row.size(), row.data(), col.data(), value.data(), false};
  for (auto _ : state) benchmark::DoNotOptimize(reader.read(view).value.data());
}
BENCHMARK(ReadTriplets)->Unit(benchmark::kMillisecond);

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::AddCustomContext("BLAS", blas_name());
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
