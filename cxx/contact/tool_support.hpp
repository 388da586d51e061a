#pragma once
// Nodes that must stick so that a tool, or the body between tools, is supported along the contact.
#include "contact/events.hpp"

namespace burnish {

/// In space nodes may all slide, in different directions: a tool is supported by a node that sticks so often at most in the passes
/// of an iteration (ALGORITHMS.md 5.3).
constexpr int MAX_SUPPORTS = 8;

/// Makes one node of a tool stick where a coordinate under force would otherwise only meet sliding friction:
/// the sliding node with the smallest slip.
/// @param refused per candidate: sticking was tried and exceeded the friction, taken last; may be empty
/// @param turning per tool: 1, none of it has to stick: turning directions resist it (METHOD.md 5.5); empty: none
/// @param geared  of a tool whose coordinate shares its force with another one's through a coupling, too, where that was not refused
///        yet: each of them may stick, and one may slide everywhere. With refused
/// @returns its candidate number or -1 if nothing had to be done
template <int Dim>
int stick_unsupported(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                      ContactState<Dim>& state, const std::vector<char>& refused = {},
                      const std::vector<char>& turning = {}, bool geared = false);

/// Weightless vertices that were made to stick (ContactNode::bears) slide without friction again where another node of their tool
/// sticks: what carries friction must not depend on the order in which nodes came (METHOD.md 3.19).
template <int Dim> void relieve_vertices(const ContactModel<Dim>& model, ContactState<Dim>& state);

/// A body that only its tools support slides one way before the neutral point of a tool, the other way behind it.
/// If no node sticks there, nothing but the curvature of the contact supports it along the tool, and the solution
/// is far off: the node that slipped least sticks, unless it could not before. @returns whether one was chosen
/// @param idle also where all slide one way; tools without friction do not count then, nor those that are 1 here: friction has to
///             hold them (held_by_friction), so that what sticks to them holds nothing
template <int Dim>
bool stick_at_neutral_point(const ContactModel<Dim>& model, ContactState<Dim>& state,
                            const std::vector<char>& refused, const std::vector<char>* idle = nullptr);

/// After events: a coordinate under force that only friction resists keeps a sticking node. Where the last one has just
/// begun to slide, the neutral point moves on toward the nodes that slide the other way: the one of them that slipped
/// least sticks; it and those of its own direction are the last resort.
/// @param pass_on false: the node that has just begun to slide may be the one. Pure rates need that: their forces are
///        not in balance, and nodes would take turns without end (article's scheme: 4208 events)
template <int Dim>
void support_after_events(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                          const std::vector<ContactEvent<Dim>>& events, bool pass_on,
                          ContactState<Dim>& state);

/// Coordinates under force zero of tools that touch nothing: no force moves them any more, so they keep the place that
/// is predicted for them. Not those held by a coupling or by what follows them. @returns their numbers
template <int Dim>
std::vector<int> idle_coordinates(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                                  const ContactState<Dim>& state);

/// Per tool: 1 if a coordinate under force would only meet sliding friction, were no node of it to stick.
template <int Dim>
std::vector<char> held_by_friction(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                                   const ContactState<Dim>& state);

/// Candidates whose stick is the only one that supports their tool.
template <int Dim>
std::vector<int> sole_supports(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                               const ContactState<Dim>& state);

} // namespace burnish
