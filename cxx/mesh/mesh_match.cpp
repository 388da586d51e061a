#include "mesh/mesh_match.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cstring>

namespace burnish {

namespace {

std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
  return hash ^ (hash >> 29);
}

std::uint64_t bits(double value) {
  std::uint64_t word = 0;
  value += 0.; // no -0
  std::memcpy(&word, &value, sizeof word);
  return word;
}

} // namespace

template <int Dim>
void require_same_mesh(const Mesh<Dim>& a, const std::string& of_a, const Mesh<Dim>& b,
                       const std::string& of_b, const char* where) {
  if (a.axisymmetric != b.axisymmetric)
    fail(where, (a.axisymmetric ? of_a : of_b) + " is axisymmetric, " + (a.axisymmetric ? of_b : of_a) +
                    " is plane; axisymmetric=true belongs to both or to neither");
  const std::string begin = of_a + " and " + of_b + " are not on the same mesh: ";
  const auto differs = [&](bool differ, const auto& text) {
    if (!differ) return;
    std::ostringstream message;
    message << begin;
    text(message);
    fail(where, message.str() + "; make both from the same space");
  };
  differs(a.num_nodes != b.num_nodes,
          [&](auto& m) { m << a.num_nodes << " and " << b.num_nodes << " nodes"; });
  differs(a.connectivity.size() != b.connectivity.size() || a.num_elements != b.num_elements,
          [&](auto& m) { m << a.num_elements << " and " << b.num_elements << " elements"; });
  const auto x = std::mismatch(a.X.begin(), a.X.end(), b.X.begin());
  differs(x.first != a.X.end(), [&](auto& m) {
    const int node = static_cast<int>(x.first - a.X.begin()) / Dim;
    m << "node " << node << " is at (" << a.node(node).transpose() << ") and at (" << b.node(node).transpose()
      << ")";
  });
  const auto n = std::mismatch(a.connectivity.begin(), a.connectivity.end(), b.connectivity.begin());
  differs(n.first != a.connectivity.end(), [&](auto& m) {
    m << "element " << (n.first - a.connectivity.begin()) / a.nodes_per_element << " has node " << *n.first
      << " and node " << *n.second;
  });
}

template <int Dim> std::uint64_t mesh_fingerprint(const Mesh<Dim>& mesh) {
  std::uint64_t hash = mixed(mesh.axisymmetric ? 2 : 1, static_cast<std::uint64_t>(mesh.nodes_per_element));
  for (const double x : mesh.X) hash = mixed(hash, bits(x));
  for (const int node : mesh.connectivity) hash = mixed(hash, static_cast<std::uint64_t>(node));
  return hash;
}

template <int Dim>
ForeignPairs foreign_pairs(const Mesh<Dim>& mesh, const std::vector<int>& row_start,
                           const std::vector<int>& col) {
  std::vector<std::vector<int>> around(static_cast<std::size_t>(mesh.num_nodes)); // elements of a node
  for (int e = 0; e < mesh.num_elements; ++e)
    for (int a = 0; a < mesh.nodes_per_element; ++a)
      around[static_cast<std::size_t>(mesh.element(e)[a])].push_back(e);
  ForeignPairs pairs;
  std::vector<int> seen_from(static_cast<std::size_t>(mesh.num_nodes), -1);
  for (int node = 0; node < mesh.num_nodes; ++node) {
    for (const int e : around[static_cast<std::size_t>(node)])
      for (int a = 0; a < mesh.nodes_per_element; ++a)
        seen_from[static_cast<std::size_t>(mesh.element(e)[a])] = node;
    for (int k = row_start[static_cast<std::size_t>(node)]; k < row_start[static_cast<std::size_t>(node) + 1];
         ++k) {
      const int other = col[static_cast<std::size_t>(k)];
      if (other == node) continue;
      ++pairs.all;
      pairs.foreign += seen_from[static_cast<std::size_t>(other)] != node;
    }
  }
  return pairs;
}

template void require_same_mesh<2>(const Mesh<2>&, const std::string&, const Mesh<2>&, const std::string&,
                                   const char*);
template void require_same_mesh<3>(const Mesh<3>&, const std::string&, const Mesh<3>&, const std::string&,
                                   const char*);
template std::uint64_t mesh_fingerprint<2>(const Mesh<2>&);
template std::uint64_t mesh_fingerprint<3>(const Mesh<3>&);
template ForeignPairs foreign_pairs<2>(const Mesh<2>&, const std::vector<int>&, const std::vector<int>&);
template ForeignPairs foreign_pairs<3>(const Mesh<3>&, const std::vector<int>&, const std::vector<int>&);

} // namespace burnish
