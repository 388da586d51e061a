#pragma once
// Which of several local foot points is the closest one.
#include <cmath>
#include <limits>

namespace burnish {

/// Takes the nearest of the foot points offered. Of equally near ones (within the tolerance) rather a normal
/// projection than the end of a piece, then the one whose parameter is closer to `near`.
class FootChoice {
public:
  /// @param near       parameter to stay close to
  /// @param period     of the parameter of a closed profile; 0: open
  /// @param tolerance  of distances [length]
  FootChoice(double near, double period, double tolerance)
      : m_near(near), m_period(period), m_tolerance(tolerance) {}
  /// True if no foot point at this distance or beyond can be taken any more.
  bool beyond(double distance) const { return distance > m_distance + m_tolerance; }
  /// @param normal  false: an end of a piece, to which the point has no normal
  /// @return true if it is the best one so far
  bool offer(double s, double distance, bool normal) {
    if (beyond(distance)) return false;
    const bool clearly = distance < m_distance - m_tolerance;
    const bool rather = normal != m_normal ? normal : std::abs(away(s)) < std::abs(away(m_s));
    if (distance < m_distance) m_distance = distance;
    if (!clearly && !rather) return false;
    m_s = s;
    m_normal = normal;
    return true;
  }
  /// The parameter of the best one; closed: on the branch nearest to near.
  double parameter() const { return m_period > 0 ? m_near + away(m_s) : m_s; }

private:
  double away(double s) const { return m_period > 0 ? std::remainder(s - m_near, m_period) : s - m_near; }

  double m_near, m_period, m_tolerance;
  double m_distance = std::numeric_limits<double>::infinity(), m_s = 0;
  bool m_normal = false;
};

} // namespace burnish
