#pragma once
// What a contact problem is made of: workpiece's surface, supports, tools, friction. Fixed once it is closed.
#include "contact/body_view.hpp"
#include "contact/contact_model.hpp"
#include "kinematics/driven_tool.hpp"

namespace burnish {

template <int Dim> class ContactSetup {
public:
  /// @param surface facets of the contact surface; its nodes without given displacement are the candidates
  /// @param fixed   per dof: displacement is given
  /// @throws std::invalid_argument for an invalid mesh, an empty contact set or wrong sizes
  ContactSetup(Mesh<Dim> mesh, std::vector<Facet<Dim>> surface, std::vector<char> fixed,
               std::shared_ptr<const FacetMeasure<Dim>> measure);
  ContactSetup(const ContactSetup&) = delete; // model and body are referred to
  ContactSetup& operator=(const ContactSetup&) = delete;

  /// Mid nodes of the surface where the script says, instead of on the curve through its vertices; see places_given.
  void place_surface(const Eigen::VectorXd& places);
  /// @param reach facets that the tool may touch; empty: the whole contact surface
  /// @throws std::invalid_argument once it is closed, or if a tool of that name is there
  void add_tool(std::shared_ptr<DrivenTool<Dim>> tool, std::shared_ptr<const FrictionLaw> friction,
                const std::vector<Facet<Dim>>& reach = {});
  /// The tools of a contact with the same body on another mesh: with their laws, reaches by label, and couplings.
  /// @throws std::invalid_argument once it is closed, or if it has tools
  void take_tools(const ContactSetup& other);
  /// Coordinate "tool.coordinate" follows others, METHOD.md 2.6.
  /// @param text formula of other coordinates of this contact, "-upper.y"
  /// @throws std::invalid_argument once it is closed; see make_coupling and Prescription::follow
  void couple(const std::string& dependent, const std::string& text);
  /// No more tools; model() and body() are complete from here on. @throws std::invalid_argument without a tool
  void close();
  bool closed() const { return m_closed; }

  const Mesh<Dim>& mesh() const { return m_mesh; }
  const std::vector<Facet<Dim>>& surface() const { return m_surface; }
  const std::vector<std::shared_ptr<DrivenTool<Dim>>>& tools() const { return m_tools; }
  const std::vector<int>& candidates() const { return m_model.candidates; }
  const ContactModel<Dim>& model() const { return m_model; }
  const BodyView<Dim>& body() const { return m_body; } ///< its mid nodes on the surface's curve
  /// Coordinates of all tools where the script placed them.
  Eigen::VectorXd placed() const;

private:
  std::vector<char> reached(const std::vector<Facet<Dim>>& facets) const;
  Mesh<Dim> m_mesh;
  std::vector<Facet<Dim>> m_surface;
  std::vector<std::shared_ptr<DrivenTool<Dim>>> m_tools;
  std::vector<std::vector<long>> m_reach; // labels that each tool may touch; empty: all
  ContactModel<Dim> m_model;
  BodyView<Dim> m_body;
  bool m_closed = false;
};

} // namespace burnish
