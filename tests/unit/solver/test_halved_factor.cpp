#include "solver/halved_factor.hpp"
#include "solver/permuted_triangle.hpp"
#include "unit/solver/elastic_sample.hpp"
#include <algorithm>
#include <condition_variable>
#include <gtest/gtest.h>
#include <mutex>
#include <set>
#include <thread>

using namespace burnish;

namespace {

/// What two threads exchange that stand for two ranks. Each waits for the other before it writes and after.
class Meeting {
public:
  std::vector<double> numbers;
  std::vector<char> bytes;
  long least[2] = {0, 0};
  void wait() {
    std::unique_lock lock(m_mutex);
    const long round = m_round;
    if (++m_waiting == 2) {
      m_waiting = 0;
      ++m_round;
      m_all.notify_all();
    } else
      m_all.wait(lock, [&] { return m_round != round; });
  }

private:
  std::mutex m_mutex;
  std::condition_variable m_all;
  int m_waiting = 0;
  long m_round = 0;
};

class Thread final : public Ranks {
public:
  Thread(Meeting& meeting, int rank) : m_meeting(meeting), m_rank(rank) {}
  int rank() const override { return m_rank; }
  int size() const override { return 2; }
  void gather(double* values, const std::vector<std::size_t>& start) override {
    if (m_rank == 0) m_meeting.numbers.resize(start[2]);
    m_meeting.wait();
    const auto own = m_meeting.numbers.begin() + start[m_rank];
    std::copy(values + start[m_rank], values + start[m_rank + 1], own);
    m_meeting.wait();
    std::copy(m_meeting.numbers.begin(), m_meeting.numbers.end(), values);
    m_meeting.wait();
  }
  void broadcast(void* data, std::size_t count, int from) override {
    char* const begin = static_cast<char*>(data);
    if (m_rank == from) m_meeting.bytes.assign(begin, begin + count);
    m_meeting.wait();
    std::copy(m_meeting.bytes.begin(), m_meeting.bytes.end(), begin);
    m_meeting.wait();
  }
  long least(long value) override {
    m_meeting.least[m_rank] = value;
    m_meeting.wait();
    const long all = std::min(m_meeting.least[0], m_meeting.least[1]);
    m_meeting.wait();
    return all;
  }

private:
  Meeting& m_meeting;
  int m_rank;
};

/// Both ranks do the same.
template <class F> void on_both(F&& f) {
  Meeting meeting;
  Thread first(meeting, 0), second(meeting, 1);
  std::thread beside([&] { f(second); });
  f(first);
  beside.join();
}

/// A matrix by its lower triangle, with its values.
struct Lower {
  std::vector<int> col_start, row;
  std::vector<double> values;
  int size() const { return static_cast<int>(col_start.size()) - 1; }
};

/// The same in the order that two ranks give to all before `first`.
struct Halved {
  EliminationOrder elimination;
  std::vector<int> place;
  Lower lower;
  Halved(const Lower& given, int first, Ranks& both) {
    Graph graph;
    for (int j = 0; j < first; ++j) {
      for (int k = given.col_start[j]; k < given.col_start[j + 1]; ++k)
        if (given.row[k] < first) graph.col.push_back(given.row[k]);
      graph.row_start.push_back(static_cast<int>(graph.col.size()));
    }
    elimination = order_of_halves(graph, Ordering::AMD, both);
    for (int j = first; j < given.size(); ++j) elimination.order.push_back(j);
    place.resize(given.size());
    for (int k = 0; k < given.size(); ++k) place[elimination.order[k]] = k;
    std::vector<std::vector<std::pair<int, double>>> columns(given.size());
    for (int j = 0; j < given.size(); ++j)
      for (int k = given.col_start[j]; k < given.col_start[j + 1]; ++k) {
        const auto [column, row] = std::minmax(place[j], place[given.row[k]]);
        columns[column].emplace_back(row, given.values[k]);
      }
    lower.col_start = {0};
    for (const auto& column : columns) {
      for (const auto& [row, value] : column) {
        lower.row.push_back(row);
        lower.values.push_back(value);
      }
      lower.col_start.push_back(static_cast<int>(lower.row.size()));
    }
  }
};

template <int Dim>
std::vector<double> values_of(const NodeBlockMatrix<Dim>& matrix, const PermutedTriangle& t) {
  std::vector<double> values;
  for (const std::uint32_t slot : t.slot) values.push_back(matrix.value[slot]);
  return values;
}

template <int Dim>
void expect_equals_one_rank(const sample::Mesh<Dim>& mesh, const std::vector<int>& candidates) {
  const auto matrix = sample::stiffness(mesh, 0.);
  const auto triangle =
      permute_candidates_last<Dim>(matrix, sample::fix<Dim>(matrix, mesh.inner), candidates);
  const int n = static_cast<int>(triangle.order.size()), first = triangle.num_interior;
  const std::vector<double> values = values_of(matrix, triangle);
  CholmodFactor alone;
  alone.analyze(triangle.col_start, triangle.row, first);
  ASSERT_EQ(alone.factorize(values), FactorStatus::OK);
  Eigen::MatrixXd b(n, 3);
  for (int c = 0; c < 3; ++c) b.col(c) = sample::random_vector(n, c + 1);
  Eigen::MatrixXd x = b, found[2], lower = b, lower_found[2], top_found[2];
  alone.solve(x);
  alone.solve_lower(lower);
  on_both([&](Ranks& both) {
    const int rank = both.rank();
    const Halved halved({triangle.col_start, triangle.row, values}, first, both);
    const auto& order = halved.elimination.order;
    EXPECT_GT(std::min(halved.elimination.halves[0], halved.elimination.halves[1]), n / 4);
    HalvedFactor factor(both, halved.elimination.halves);
    factor.analyze(halved.lower.col_start, halved.lower.row, first);
    ASSERT_EQ(factor.factorize(halved.lower.values), FactorStatus::OK);
    Eigen::MatrixXd solved = b(order, Eigen::all), swept = solved;
    factor.solve(solved);
    factor.solve_lower(swept);
    found[rank] = solved(halved.place, Eigen::all);
    lower_found[rank] = swept(halved.place, Eigen::all);
    top_found[rank] = factor.trailing_factor(first);
    EXPECT_GT(factor.factor_entries(), static_cast<std::size_t>(n));
  });
  const Eigen::MatrixXd top = alone.trailing_factor(first);
  for (int rank : {0, 1}) {
    EXPECT_LT((found[rank] - x).norm(), 1e-11 * x.norm());
    EXPECT_LE((top_found[rank] - top).norm(), 1e-11 * top.norm());
    EXPECT_LE((lower_found[rank] - lower).bottomRows(n - first).norm(), 1e-11 * lower.norm());
  }
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(top_found[0], top_found[1]);
}

} // namespace

TEST(HalvedFactor, EqualsTheFactorOfOneRank) {
  const auto ring = sample::with_mid_nodes(sample::ring_sector(4, 12));
  expect_equals_one_rank<2>(ring, ring.outer);
  const auto cube = sample::cube(5);
  expect_equals_one_rank<3>(cube, {cube.outer.begin(), cube.outer.begin() + 9});
  expect_equals_one_rank<3>(cube, {});
}

// Where one rank's half is to blame, where t is, and what is too small to be cut.
TEST(HalvedFactor, NotPositiveDefiniteIsSaidByBoth) {
  const auto factored = [](const std::vector<double>& diagonal) {
    FactorStatus status[2];
    const int n = static_cast<int>(diagonal.size());
    std::vector<int> start(n + 1), row;
    std::vector<double> values;
    for (int j = 0; j < n; ++j) { // a chain
      row.push_back(j);
      values.push_back(diagonal[j]);
      if (j + 1 < n) {
        row.push_back(j + 1);
        values.push_back(-1);
      }
      start[j + 1] = static_cast<int>(row.size());
    }
    on_both([&](Ranks& both) {
      const Halved halved({start, row, values}, n - 1, both);
      HalvedFactor factor(both, halved.elimination.halves);
      factor.analyze(halved.lower.col_start, halved.lower.row, n - 1);
      status[both.rank()] = factor.factorize(halved.lower.values);
      EXPECT_EQ(factor.is_factorized(), status[both.rank()] == FactorStatus::OK);
    });
    EXPECT_EQ(status[0], status[1]);
    return status[0];
  };
  for (int n : {1, 2, 3, 40}) {
    std::vector<double> diagonal(n, 2.);
    EXPECT_EQ(factored(diagonal), FactorStatus::OK) << n;
    for (int bad = 0; bad < n; ++bad) {
      diagonal.assign(n, 2.);
      diagonal[bad] = bad == 0 || bad == n - 1 ? -1 : 0.5;
      EXPECT_EQ(factored(diagonal), FactorStatus::NOT_POSITIVE_DEFINITE) << n << " " << bad;
    }
  }
}

TEST(HalvedFactor, RefusesWrongOrder) {
  Meeting meeting;
  Thread first(meeting, 0);
  HalvedFactor factor(first, {1, 1});
  EXPECT_THROW(factor.factorize({}), std::logic_error);
  EXPECT_THROW(factor.analyze({0, 2, 3}, {0, 1, 1}), std::logic_error); // they touch
  EXPECT_THROW(factor.analyze({0, 1}, {0}), std::logic_error);          // more than there is
  Eigen::MatrixXd b(3, 1);
  EXPECT_THROW(factor.solve(b), std::logic_error);
  EXPECT_THROW(factor.trailing_factor(0), std::logic_error);
}

// Ten-node tetrahedra, six in each of l x m x k cells: edges between all nodes of an element. By itself METIS takes halves of 1617
// and 1191, 4846 and 4043, 9588 and 10 800, 3418 and 4782 nodes.
TEST(HalvesAndSeparator, AreEvenAndDoNotTouch) {
  using Place = std::array<int, 3>; // in halves of a cell
  for (const auto& [l, m, k] : {Place{12, 6, 4}, Place{18, 9, 6}, Place{24, 12, 8}, Place{20, 20, 2}}) {
    const int height = 2 * k + 1, section = (2 * m + 1) * height;
    std::vector<std::set<int>> neighbors((2 * l + 1) * section);
    for (int cell = 0; cell < l * m * k; ++cell) {
      Place axes{0, 1, 2};
      do {
        std::array<Place, 4> corner{Place{2 * (cell / (m * k)), 2 * (cell / k % m), 2 * (cell % k)}};
        std::vector<int> nodes;
        for (int c = 1; c < 4; ++c) (corner[c] = corner[c - 1])[axes[c - 1]] += 2;
        for (const Place& a : corner)
          for (const Place& b : corner)
            nodes.push_back((a[0] + b[0]) / 2 * section + (a[1] + b[1]) / 2 * height + (a[2] + b[2]) / 2);
        for (const int n : nodes) neighbors[n].insert(nodes.begin(), nodes.end());
      } while (std::next_permutation(axes.begin(), axes.end()));
    }
    Graph graph;
    for (const std::set<int>& of : neighbors) {
      graph.col.insert(graph.col.end(), of.begin(), of.end());
      graph.row_start.push_back(static_cast<int>(graph.col.size()));
    }
    const std::vector<int> part = halves_and_separator(graph);
    std::array<long, 3> count{};
    for (const int p : part) ++count[p];
    EXPECT_LE(100 * std::max(count[0], count[1]), 108 * std::min(count[0], count[1])) << l;
    EXPECT_LE(count[SEPARATOR], section + section / 50) << l;
    for (int v = 0; v < graph.size(); ++v)
      for (const int w : neighbors[v]) EXPECT_NE(part[v] + part[w], 1) << v << " " << w;
  }
}
