#include "cad/occ/cad_chain.hpp"
#include "base/error.hpp"
#include "cad/occ/corner_fillet.hpp"
#include "geometry/plane.hpp"
#include <algorithm>

namespace burnish {

namespace {

constexpr const char* CAD_CHAIN = "CadCurve";
constexpr double JOINED = 1e-6; // of the size
constexpr double SMOOTH = 1e-3; // rad

std::string number(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

/// Ends 2i and 2i + 1 of curve i, and which of them lie at the same vertex.
class Joints {
public:
  explicit Joints(const std::vector<CadPiece>& curves) : m_curves(curves) {
    for (const CadPiece& curve : curves) {
      m_x.push_back(curve.start().x);
      m_x.push_back(curve.end().x);
    }
    double size = 0;
    for (const CadPiece& curve : curves)
      for (const double part : {0., 0.3, 0.7, 1.})
        size = std::max(size, (curve.at(part * curve.length()).x - m_x[0]).norm());
    for (const CadPiece& curve : curves)
      if (curve.length() <= JOINED * size) fail_short(curve, size);
    for (std::size_t a = 0; a < m_x.size(); ++a) {
      std::vector<std::size_t> here;
      for (std::size_t b = 0; b < m_x.size(); ++b)
        if (b != a && (m_x[a] - m_x[b]).norm() <= JOINED * size) here.push_back(b);
      if (here.size() > 1) fail_branch(a, here);
      m_partner.push_back(here.empty() ? NONE : here[0]);
    }
  }
  static constexpr std::size_t NONE = static_cast<std::size_t>(-1);
  /// The other end at the vertex of this one.
  std::size_t partner(std::size_t end) const { return m_partner[end]; }
  const Vector<2>& x(std::size_t end) const { return m_x[end]; }
  std::size_t size() const { return m_x.size(); }

private:
  [[noreturn]] static void fail_short(const CadPiece& curve, double size) {
    fail(CAD_CHAIN, "curve " + std::to_string(curve.tag()) + " at " + place_text(curve.start().x, size) +
                        " is too short: " + number(curve.length()) + " long, in a chain of size " +
                        number(size) + " at least " + number(JOINED * size) +
                        " is needed; take it out of the drawing");
  }
  [[noreturn]] void fail_branch(std::size_t a, const std::vector<std::size_t>& here) const {
    std::string tags = std::to_string(m_curves[a / 2].tag());
    for (const std::size_t b : here) tags += ", " + std::to_string(m_curves[b / 2].tag());
    fail(CAD_CHAIN, "the chain branches at " + place_text(m_x[a], m_curves[a / 2].length()) + ": curves " +
                        tags + " meet there; name the curves of one chain (curves = [...])");
  }
  const std::vector<CadPiece>& m_curves;
  std::vector<Vector<2>> m_x;
  std::vector<std::size_t> m_partner;
};

[[noreturn]] void fail_apart(const std::vector<CadPiece>& curves, const Joints& joints,
                             const std::vector<char>& used) {
  std::string in, out;
  for (std::size_t i = 0; i < curves.size(); ++i)
    (used[i] ? in : out) += ((used[i] ? in : out).empty() ? "" : ", ") + std::to_string(curves[i].tag());
  std::size_t a = Joints::NONE, b = a;
  for (std::size_t i = 0; i < joints.size(); ++i)
    for (std::size_t j = 0; j < joints.size(); ++j) {
      if (!used[i / 2] || used[j / 2]) continue;
      if (a == Joints::NONE || (joints.x(i) - joints.x(j)).norm() < (joints.x(a) - joints.x(b)).norm())
        a = i, b = j;
    }
  fail(CAD_CHAIN, "the curves do not join into one chain: " + in + " and apart from them " + out +
                      "; their nearest ends are those of curve " + std::to_string(curves[a / 2].tag()) +
                      " at " + place_text(joints.x(a), curves[a / 2].length()) + " and of curve " +
                      std::to_string(curves[b / 2].tag()) + " at " +
                      place_text(joints.x(b), curves[b / 2].length()));
}

void check_joint(const CadPiece& before, const CadPiece& after) {
  const CadValue a = before.end(), b = after.start();
  for (const auto& [value, piece] : {std::make_pair(a, &before), std::make_pair(b, &after)})
    if (value.first.norm() < 1e-6) // 1 on average
      fail(CAD_CHAIN, "curve " + std::to_string(piece->tag()) + " has no tangent at its end " +
                          place_text(value.x, piece->length()));
  const double angle = std::abs(std::atan2(left_of(a.first).dot(b.first), a.first.dot(b.first)));
  if (angle <= SMOOTH) return;
  const bool alone = before.tag() == after.tag();
  const std::string place = place_text(a.x, before.length()),
                    which = alone ? "curve " + std::to_string(before.tag())
                                  : "curves " + std::to_string(before.tag()) + " and " +
                                        std::to_string(after.tag());
  if (angle > M_PI - SMOOTH)
    fail(CAD_CHAIN,
         which + (alone ? " turns back on itself where it closes, at " : " turn back on each other at ") +
             place + ": a cusp, or a curve drawn twice");
  fail(CAD_CHAIN, which + (alone ? " closes with" : " make") + " a corner of " + number(angle * 180 / M_PI) +
                      " degrees at " + place + "; round it with a fillet in the CAD system" +
                      fillet_text(radii_that_fit(before, after), 1));
}

} // namespace

CadChain chained(const std::vector<CadPiece>& curves) {
  const Joints joints(curves);
  std::vector<char> used(curves.size(), 0);
  CadChain chain{{}, false};
  // forward from the end of the first curve, then backward from its start
  used[0] = 1;
  chain.pieces.push_back(curves[0]);
  for (const bool forward : {true, false}) {
    std::size_t end = forward ? 1 : 0;
    while (!chain.closed && joints.partner(end) != Joints::NONE) {
      const std::size_t entered = joints.partner(end), i = entered / 2;
      chain.closed = used[i];
      if (chain.closed) break;
      used[i] = 1;
      CadPiece piece = curves[i];
      if ((entered % 2 == 1) == forward) piece.reverse();
      chain.pieces.insert(forward ? chain.pieces.end() : chain.pieces.begin(), piece);
      end = entered ^ 1u;
    }
  }
  if (std::count(used.begin(), used.end(), 0) > 0) fail_apart(curves, joints, used);
  const std::size_t n = chain.pieces.size();
  for (std::size_t i = 0; i < n; ++i)
    if (i + 1 < n || chain.closed) check_joint(chain.pieces[i], chain.pieces[(i + 1) % n]);
  return chain;
}

} // namespace burnish
