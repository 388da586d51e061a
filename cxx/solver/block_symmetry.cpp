#include "solver/block_symmetry.hpp"
#include "base/error.hpp"
#include <cmath>

namespace burnish {

template <int Dim>
void require_symmetric(const NodeBlockMatrix<Dim>& K, double tolerance, const char* where) {
  double largest = 0, worst = 0, entry = 0, mirror = 0;
  int row = 0, col = 0;
  for (int node = 0; node < K.num_nodes; ++node)
    for (int k = K.row_start[node]; k < K.row_start[node + 1]; ++k) {
      const double *block = K.block(k), *other = K.block(K.find(K.col[k], node));
      for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j) {
          const double a = block[i * Dim + j], b = other[j * Dim + i];
          largest = std::max(largest, std::abs(a));
          if (std::abs(a - b) <= worst) continue;
          worst = std::abs(a - b);
          entry = a;
          mirror = b;
          row = Dim * node + i;
          col = Dim * K.col[k] + j;
        }
    }
  if (worst <= tolerance * largest) return;
  std::ostringstream text;
  text << "K is not symmetric: K(" << row << ", " << col << ") = " << entry << ", K(" << col << ", " << row
       << ") = " << mirror << " (nodes " << row / Dim << " and " << col / Dim << "), asymmetry "
       << worst / largest << " of the largest entry, allowed " << tolerance
       << "; give the symmetric part, or condense K for a solver of general matrices";
  fail(where, text.str());
}

template void require_symmetric<2>(const NodeBlockMatrix<2>&, double, const char*);
template void require_symmetric<3>(const NodeBlockMatrix<3>&, double, const char*);

} // namespace burnish
