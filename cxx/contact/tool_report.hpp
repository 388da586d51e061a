#pragma once
// What a report says of each tool: names of all coordinates, nodes in contact, resultant of the forces.
#include "contact/contact_model.hpp"

namespace burnish {

/// Names of the coordinates of all tools, one tool after another, as in ContactState::q: plain ("x") with
/// one tool, with the tool's name before ("roller.x") with several, or where a plain one would be that of
/// another column of a history: "t", "contact", "Q_a" beside "a".
/// @throws std::invalid_argument if two tools bear the same name
template <int Dim>
std::vector<std::string> coordinate_names(const std::vector<std::shared_ptr<const Tool<Dim>>>& tools);

/// Number of candidates in a state.
/// @param what  "free", "touched", "sliding", "sticking", "leaving", "receding", or "contact":
///              touched, sliding or sticking
/// @param tool  index into ContactModel::tools: only nodes whose tool (in contact or nearest) it is;
///              -1: all
/// @throws std::invalid_argument "where: ..." for another word
template <int Dim>
long count_nodes(const ContactState<Dim>& state, const std::string& what, const char* where, int tool = -1);

/// Sum of the contact forces that the body exerts on one tool: minus the forces on the nodes in contact
/// with it, of constrained ones without what their supports take.
/// @param R internal minus external nodal force [force]  @return [force]
template <int Dim>
Vector<Dim> tool_resultant(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                           const Eigen::VectorXd& R, int tool);

} // namespace burnish
