#include "cad/occ/cad_crossings.hpp"
#include "base/error.hpp"
#include "geometry/plane.hpp"
#include <algorithm>

namespace burnish {

namespace {

constexpr int MOST_HALVINGS = 12; // of two cells that come close

struct Chord {
  double begin, end; ///< parameters within the piece
  Vector<2> x[2];
  double sag;
};

bool chords_cross(const Chord& a, const Chord& b) {
  const auto apart = [](const Chord& line, const Chord& other) {
    const Vector<2> along = line.x[1] - line.x[0];
    return cross(along, other.x[0] - line.x[0]) * cross(along, other.x[1] - line.x[0]) > 0;
  };
  return !apart(a, b) && !apart(b, a);
}

bool boxes_apart(const Chord& a, const Chord& b) {
  const double sag = a.sag + b.sag;
  for (int k = 0; k < 2; ++k)
    if (std::max(a.x[0][k], a.x[1][k]) + sag < std::min(b.x[0][k], b.x[1][k]) ||
        std::max(b.x[0][k], b.x[1][k]) + sag < std::min(a.x[0][k], a.x[1][k]))
      return true;
  return false;
}

double distance(const Chord& a, const Vector<2>& x) {
  const Vector<2> along = a.x[1] - a.x[0];
  const double length2 = along.squaredNorm();
  const double part = length2 > 0 ? std::clamp(along.dot(x - a.x[0]) / length2, 0., 1.) : 0.;
  return (a.x[0] + part * along - x).norm();
}

bool close_by(const Chord& a, const Chord& b) {
  if (boxes_apart(a, b)) return false;
  if (chords_cross(a, b)) return true;
  double least = std::min(distance(a, b.x[0]), distance(a, b.x[1]));
  least = std::min({least, distance(b, a.x[0]), distance(b, a.x[1])});
  return least <= a.sag + b.sag;
}

// Halving makes sags four times smaller; three times is safe.
std::array<Chord, 2> halves(const Chord& chord, const CadPiece& piece) {
  const double middle = (chord.begin + chord.end) / 2;
  const Vector<2> x = piece.at(middle).x;
  return {Chord{chord.begin, middle, {chord.x[0], x}, chord.sag / 3},
          Chord{middle, chord.end, {x, chord.x[1]}, chord.sag / 3}};
}

bool meet(const Chord& a, const CadPiece& of_a, const Chord& b, const CadPiece& of_b, int depth,
          Vector<2>& place) {
  if (!close_by(a, b)) return false;
  place = (a.x[0] + a.x[1]) / 2;
  if (depth == MOST_HALVINGS) return true;
  for (const Chord& half : halves(a, of_a))
    for (const Chord& other : halves(b, of_b))
      if (meet(half, of_a, other, of_b, depth + 1, place)) return true;
  return false;
}

Chord chord_of(const CadCell& cell) { return {cell.begin, cell.end, {cell.x[0], cell.x[1]}, cell.sag}; }

[[noreturn]] void fail_crossing(const Vector<2>& x, double size, int a, int b) {
  std::ostringstream text;
  text << "the chain crosses or touches itself near " << place_text(x, size) << ": ";
  if (a == b)
    text << "curve " << a << " with itself";
  else
    text << "curves " << a << " and " << b;
  fail("CadCurve", text.str());
}

} // namespace

void check_crossings(const CadChain& chain, const std::vector<CadCell>& cells) {
  std::vector<double> turned{0};
  double length = 0;
  for (const CadCell& cell : cells) turned.push_back(turned.back() + cell.turn);
  for (const CadPiece& piece : chain.pieces) length += piece.length();
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t j = i + 1; j < cells.size(); ++j) {
      const double between = turned[j + 1] - turned[i], around = turned.back() - (turned[j] - turned[i + 1]);
      if (between < M_PI || (chain.closed && around < M_PI)) continue;
      const CadPiece &a = chain.pieces[cells[i].piece], &b = chain.pieces[cells[j].piece];
      Vector<2> place;
      if (meet(chord_of(cells[i]), a, chord_of(cells[j]), b, 0, place))
        fail_crossing(place, length, a.tag(), b.tag());
    }
}

} // namespace burnish
