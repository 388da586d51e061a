#pragma once
// Global search for the closest point of a chain of CAD curves: a table of short chords with bounds, then
// Newton's method on the exact curve in the few cells that can hold it.
#include "cad/occ/cad_chain.hpp"
#include "geometry/foot_choice.hpp"

namespace burnish {

/// Part of the chain that turns by less than 0.1 rad, between two samples of it.
struct CadCell {
  std::size_t piece;
  double begin, end; ///< parameters within the piece
  Vector<2> x[2];    ///< points at both, ...
  Vector<2> t[2];    ///< ... and x_s
  double turn;       ///< sum of the turns of its parts [rad]
  double sag = 0;    ///< the curve stays this close to the chord [length]
  /// A bound of |x_ss|/|x_s|^2; nearer than 1/curvature_bound there is one foot point at most [1/length].
  double curvature_bound = 0;
  Vector<2> hollow[2] = {{0, 0}, {0, 0}}; ///< x_ss at both ends if it bends to one side only, else zero
};

/// A foot point on the chain.
struct CadFoot {
  std::size_t piece = 0;
  double s = 0;        ///< within the piece
  bool normal = false; ///< false: an end of a cell without normal projection
};

class CadSearch {
public:
  /// @throws std::invalid_argument where a curve has no tangent
  explicit CadSearch(const std::vector<CadPiece>& pieces);
  const std::vector<CadCell>& cells() const { return m_cells; }
  /// The best foot point over the whole chain; offers are made to `choice` in the chain's parameter,
  /// start[piece] + s.
  CadFoot closest(const std::vector<CadPiece>& pieces, const std::vector<double>& start, const Vector<2>& x,
                  FootChoice& choice) const;

private:
  struct Group {
    std::size_t begin, end; ///< cells
    Vector<2> center;
    double radius;
  };
  void add(const CadPiece& piece, std::size_t index, double begin, double end, int depth);
  void make_groups();
  double reach_of(const Group& group, const Vector<2>& x, double reach, std::vector<double>& nearest) const;

  std::vector<CadCell> m_cells;
  std::vector<Group> m_groups;
};

} // namespace burnish
