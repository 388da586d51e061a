#pragma once
// Predicted state of a step: the last step's increment and contact states carried along with the tools
// (ALGORITHMS.md 3).
#include "contact/body_view.hpp"
#include "contact/node_test.hpp"
#include "mesh/mesh_locator.hpp"
#include "mesh/point_tree.hpp"

namespace burnish {

/// The step before: what the predictor carries on. Plain data.
template <int Dim> struct StepHistory {
  Eigen::VectorXd du;    ///< displacement increment of the last step, empty before the first
  Eigen::VectorXd dq;    ///< increment of the coordinates
  Eigen::VectorXd q_old; ///< coordinates at its start
  double dt = 0;
  bool own = true; ///< nodes that repeat their own increments came nearer to the last step than carried ones
};

/// The two ways to go on [length]; empty: there is no step before.
struct PredictedWays {
  Eigen::VectorXd carried, own;
  /// Which came nearer to the accepted u; `before` unless the other one is better by a tenth.
  bool own_nearer(const Eigen::VectorXd& u, bool before) const;
};

template <int Dim> struct Prediction {
  Eigen::VectorXd u;
  ContactState<Dim> state;
  PredictedWays ways;
  EntryPlaces<Dim> entry;
};

/// What becomes of the contact states.
struct CarriedStates {
  bool carry = true; ///< carry them along (false: states stay, event stepping)
  bool tied = true;  ///< tie edges in contact by the states that come of it (contact/tied_edges.hpp)
};

template <int Dim> class Predictor {
public:
  /// @param mesh, model, body must outlive it
  Predictor(const Mesh<Dim>& mesh, const ContactModel<Dim>& model, const BodyView<Dim>& body);
  const MeshLocator<Dim>& locator() const { return m_locator; }

  /// @param state, u accepted state at the start of the step; slips are counted from here
  Prediction<Dim> predict(const PrescribedValues& prescribed, const ContactState<Dim>& state,
                          const Eigen::VectorXd& u, const StepHistory<Dim>& history, double dt,
                          const CarriedStates& states) const;
  /// The accepted state as it is: the start of a step of pure rates.
  Prediction<Dim> rest(const ContactState<Dim>& state, const Eigen::VectorXd& u) const;

private:
  struct CarrierMotion;
  CarrierMotion carrier_motion(int tool, const Eigen::VectorXd& q_older, const Eigen::VectorXd& q_old,
                               const Eigen::VectorXd& q_new) const;
  PredictedWays carry_increment(const ContactState<Dim>& state, const Eigen::VectorXd& u,
                                const StepHistory<Dim>& history, const std::vector<CarrierMotion>& motions,
                                double ratio) const;
  EntryPlaces<Dim> entry_places(const ContactState<Dim>& state, const Eigen::VectorXd& u) const;
  SurfacePlace<Dim> followed_across(const std::vector<Pose<Dim>>& poses, int candidate,
                                    const ContactNode<Dim>& node, const Vector<Dim>& x) const;
  void carry_states(const ContactState<Dim>& old, const std::vector<CarrierMotion>& motions, bool tied,
                    ContactState<Dim>& state) const;
  void place_contact_nodes(const CarriedStates& states, const std::vector<ContactNode<Dim>>& before,
                           ContactState<Dim>& state, const Eigen::VectorXd& u) const;
  void place_contact_node(const std::vector<Pose<Dim>>& poses, int candidate, bool may_stick,
                          ContactState<Dim>& state, const Eigen::VectorXd& u) const;

  const Mesh<Dim>& m_mesh;
  const ContactModel<Dim>& m_model;
  const BodyView<Dim>& m_body;
  MeshLocator<Dim> m_locator;
  PointTree<Dim> m_candidates; // in the reference configuration
};

} // namespace burnish
