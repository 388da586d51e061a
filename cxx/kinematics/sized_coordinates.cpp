#include "kinematics/sized_coordinates.hpp"
#include "base/error.hpp"
#include <sstream>
#include <utility>

namespace burnish {
namespace {

// The pose of a frame that further coordinates do not move.
template <int Dim> Pose<Dim> extended(const Pose<Dim>& frame, std::size_t size) {
  Pose<Dim> pose = blank_pose<Dim>(static_cast<int>(size));
  pose.origin = frame.origin;
  pose.R = frame.R;
  for (std::size_t k = 0; k < frame.R_q.size(); ++k) {
    pose.origin_q[k] = frame.origin_q[k];
    pose.R_q[k] = frame.R_q[k];
    for (std::size_t l = 0; l < frame.R_q.size(); ++l) {
      pose.origin_qq[k][l] = frame.origin_qq[k][l];
      pose.R_qq[k][l] = frame.R_qq[k][l];
    }
  }
  return pose;
}

[[noreturn]] void fail_size(const std::string& what, const std::vector<std::string>& names,
                            const Eigen::VectorXd& q, double size) {
  std::ostringstream text;
  text << what << " is " << size << " at ";
  for (std::size_t k = 0; k < names.size(); ++k)
    text << (k ? ", " : "") << names[k] << " = " << q[static_cast<Eigen::Index>(k)];
  throw FormulaDomainError(text.str() + ", expected > 0");
}

} // namespace

template <int Dim>
SizedCoordinates<Dim>::SizedCoordinates(const std::string& tool,
                                        std::shared_ptr<const Coordinates<Dim>> frame,
                                        std::vector<std::string> names, const std::string& size,
                                        const std::map<std::string, double>& parameters)
    : m_frame(std::move(frame)), m_names(std::move(names)),
      m_what("size of tool \"" + tool + "\" " + quoted(size)),
      m_size("size of tool \"" + tool + "\"", size, {m_names, parameters}) {
  bool grows = false;
  for (int k = 0; k < this->size(); ++k) {
    grows = grows || m_size.depends_on(k);
    m_first.push_back(m_size.derivative(k));
    m_second.emplace_back();
    for (int l = 0; l <= k; ++l) m_second.back().push_back(m_first.back().derivative(l));
  }
  if (!grows)
    fail("tool.coordinates",
         m_what + " depends on no coordinate, expected a name: a shape has its lengths without");
}

template <int Dim> Pose<Dim> SizedCoordinates<Dim>::pose(const Eigen::VectorXd& q) const {
  require_coordinates("SizedCoordinates::pose", m_names, q);
  Pose<Dim> pose = extended(m_frame->pose(q.head(m_frame->size())), m_names.size());
  pose.size = m_size(q.data());
  if (!(pose.size > 0)) fail_size(m_what, m_names, q, pose.size);
  const Eigen::Index count = q.size();
  pose.size_q.resize(count);
  pose.size_qq.resize(count, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    pose.size_q[k] = m_first[static_cast<std::size_t>(k)](q.data());
    for (Eigen::Index l = 0; l <= k; ++l)
      pose.size_qq(k, l) = pose.size_qq(l, k) =
          m_second[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)](q.data());
  }
  return pose;
}

template <int Dim>
RigidMotion<Dim> SizedCoordinates<Dim>::carrier(const Eigen::VectorXd& q_from,
                                                const Eigen::VectorXd& q_to) const {
  return m_frame->carrier(q_from.head(m_frame->size()), q_to.head(m_frame->size()));
}

template <int Dim> Eigen::VectorXd SizedCoordinates<Dim>::reference_at(const Eigen::VectorXd& q) const {
  return m_frame->reference_at(q.head(m_frame->size()));
}

template class SizedCoordinates<2>;
template class SizedCoordinates<3>;

} // namespace burnish
