#include "material/internal_variables.hpp"
#include "base/error.hpp"

namespace burnish {

template <int Dim>
InternalVariables<Dim>::InternalVariables(std::vector<InternalVariable> list) : m_list(std::move(list)) {
  for (std::size_t k = 0; k < m_list.size(); ++k) {
    const std::string& name = m_list[k].name;
    require(!name.empty() && find(name) == static_cast<int>(k), "InternalVariables", "name", name,
            "a name, and each once");
    m_offset.push_back(m_size);
    m_size += num_components<Dim>(m_list[k].kind);
  }
}

template <int Dim> int InternalVariables<Dim>::find(const std::string& name) const {
  for (std::size_t k = 0; k < m_list.size(); ++k)
    if (m_list[k].name == name) return static_cast<int>(k);
  return -1;
}

template <int Dim> std::string InternalVariables<Dim>::names() const {
  std::string text;
  for (const InternalVariable& variable : m_list) text += (text.empty() ? "" : ", ") + variable.name;
  return text.empty() ? "none" : text;
}

template <int Dim> std::vector<double> InternalVariables<Dim>::initial() const {
  std::vector<double> values;
  for (const InternalVariable& variable : m_list)
    values.insert(values.end(), num_components<Dim>(variable.kind), variable.initial);
  return values;
}

template class InternalVariables<2>;
template class InternalVariables<3>;

} // namespace burnish
