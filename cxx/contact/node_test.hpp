#pragma once
// The test of one candidate's state at a solution (METHOD.md 5.4).
#include "contact/tied_edges.hpp"
#include "contact/tolerances.hpp"

namespace burnish {

/// What a step has done to a candidate so far.
struct EntryRecord {
  int releases = 0; ///< counted by the tests
  double gap = 0;   ///< at the start of the step, of a free one; 0: it enters where it was then [length]
};
/// Where free nodes were when the step began, as if they touched there, and how those slid that were released in this step: the
/// direction of slip in `nodes`.
template <int Dim> struct EntryPlaces {
  std::vector<ContactNode<Dim>> nodes; ///< per candidate
  std::vector<EntryRecord> records;    ///< per candidate
};

/// Refers to what belongs to the iteration.
template <int Dim> class NodeTest {
public:
  /// @param poses of the tools at the solution; @param entry counts releases
  NodeTest(const ContactModel<Dim>& model, const std::vector<Pose<Dim>>& poses, const Tolerances& tolerances,
           EntryPlaces<Dim>& entry)
      : m_model(model), m_poses(poses), m_tolerances(tolerances), m_entry(entry) {}

  /// Tests a candidate and changes its state. A sticking node with N < 0 first slides; only a sliding node is released.
  /// @param solved   its place after the increment; @param F force of the tool on it then, of a free one zero [force]
  /// @param deciding force by which its stick and slip are decided; a tied node is only released
  /// @param x        its position then [length]
  /// @param node     state that the increment was made with; changed
  /// @returns whether it changed
  bool operator()(int candidate, const ContactNode<Dim>& solved, const Vector<Dim>& F,
                  const DecidingForce<Dim>& deciding, const Vector<Dim>& x, ContactNode<Dim>& node) const;

private:
  bool test_contact(int candidate, const ContactNode<Dim>& solved, const Vector<Dim>& F,
                    const DecidingForce<Dim>& deciding, ContactNode<Dim>& node) const;
  bool test_free(int candidate, const Vector<Dim>& x, ContactNode<Dim>& node) const;
  void enter(int candidate, const SurfaceFoot<Dim>& foot, ContactNode<Dim>& node) const;
  SurfacePlace<Dim> touching_place(int candidate, const SurfaceFoot<Dim>& foot) const;

  const ContactModel<Dim>& m_model;
  const std::vector<Pose<Dim>>& m_poses;
  const Tolerances& m_tolerances;
  EntryPlaces<Dim>& m_entry;
};

} // namespace burnish
