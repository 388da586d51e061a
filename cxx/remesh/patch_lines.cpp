#include "remesh/patch_lines.hpp"
#include "remesh/deformed_boundary.hpp"
#include <algorithm>
#include <cmath>
#include <map>

namespace burnish {
namespace {

/// An edge between two patches.
struct Piece {
  std::array<int, 2> patches;
  Parabola<3> x;
  std::array<int, 3> node; // start, middle, -1 on a linear one, end
  bool used = false;
};
using Pieces = std::vector<Piece>;
using AtVertex = std::map<int, std::vector<int>>; // pieces

Pieces pieces_of(const DeformedSurface& surface) {
  std::map<std::pair<int, int>, std::pair<Piece, int>> edges; // and the patch of the first face there
  Pieces pieces;
  for (const BoundaryFace& face : surface.faces())
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = SimplexEdges<2>::ends[i];
      const int from = face.facet.vertex[a], to = face.facet.vertex[b], middle = face.facet.middle[i];
      const auto [at, fresh] = edges.emplace(std::minmax(from, to), std::pair<Piece, int>());
      if (fresh) {
        const Vector<3> half = middle < 0 ? Vector<3>(0.5 * (face.x[a] + face.x[b])) : face.x[3 + i];
        at->second = {{{}, {face.x[a], half, face.x[b]}, {from, middle, to}}, face.patch};
      } else if (at->second.second != face.patch) {
        at->second.first.patches = {std::min(at->second.second, face.patch),
                                    std::max(at->second.second, face.patch)};
        pieces.push_back(at->second.first);
      }
    }
  return pieces;
}

int other_end(const Piece& piece, int vertex) {
  return piece.node[0] == vertex ? piece.node[2] : piece.node[0];
}
// Direction in which a piece leaves a vertex.
Vector<3> leaves(const Piece& piece, int vertex) {
  const Parabola<3>& x = piece.x;
  return (piece.node[0] == vertex ? -3 * x[0] + 4 * x[1] - x[2] : -3 * x[2] + 4 * x[1] - x[0]).normalized();
}
bool is_corner(const Pieces& pieces, const std::vector<int>& at, int vertex) {
  if (at.size() != 2 || pieces[at[0]].patches != pieces[at[1]].patches) return true;
  return -leaves(pieces[at[0]], vertex).dot(leaves(pieces[at[1]], vertex)) < std::cos(SHARP_TURN);
}

// From a vertex along a piece to the next corner, or around.
PatchLine follow(Pieces& pieces, const AtVertex& at, int vertex, int piece) {
  PatchLine line{pieces[piece].patches, {vertex}};
  for (;;) {
    pieces[piece].used = true;
    vertex = other_end(pieces[piece], vertex);
    if (pieces[piece].node[1] >= 0) line.nodes.push_back(pieces[piece].node[1]);
    line.nodes.push_back(vertex);
    const std::vector<int>& here = at.at(vertex);
    if (vertex == line.nodes.front() || is_corner(pieces, here, vertex)) return line;
    piece = here[0] == piece ? here[1] : here[0];
  }
}

} // namespace

std::vector<PatchLine> patch_lines(const DeformedSurface& surface) {
  Pieces pieces = pieces_of(surface);
  AtVertex at;
  for (std::size_t k = 0; k < pieces.size(); ++k)
    for (const int end : {0, 2}) at[pieces[k].node[end]].push_back(static_cast<int>(k));
  std::vector<PatchLine> lines;
  for (const bool corners : {true, false}) // what is left then is closed
    for (const auto& [vertex, here] : at)
      for (const int piece : here)
        if (!pieces[piece].used && (!corners || is_corner(pieces, here, vertex)))
          lines.push_back(follow(pieces, at, vertex, piece));
  return lines;
}

} // namespace burnish
