#include "contact/pass_choice.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr int ALONE = 6; // passes with one change alone, after states that have been there before

// A fixed pseudo-random sequence: a run goes the same way every time, whatever the order of the nodes.
unsigned drawn(unsigned& seed) {
  seed = seed * 1103515245u + 12345u;
  return seed >> 16;
}

} // namespace

template <int Dim>
PassChoice<Dim>::PassChoice(const ContactModel<Dim>& model, const std::vector<int>& window)
    : m_model(model), m_window(window), m_kind(model.candidates.size(), Kind::NONE) {}

template <int Dim>
typename PassChoice<Dim>::Kind PassChoice<Dim>::kind_of(const ContactNode<Dim>& before,
                                                        const ContactNode<Dim>& after) {
  if (in_contact(before.state) != in_contact(after.state))
    return in_contact(after.state) ? Kind::ENTERS : Kind::LEAVES;
  const bool turns = before.state != after.state || before.tied != after.tied ||
                     !(before.slip_direction - after.slip_direction).isZero(0.5);
  return turns ? Kind::TURNS : Kind::NONE;
}

// Candidates that turn, one by one; of those that enter or leave every worst one: in the plane of its run, in space next to it.
template <int Dim> std::vector<int> PassChoice<Dim>::worst_of(const std::vector<double>& severity) const {
  std::vector<int> chosen;
  std::vector<char> done(m_kind.size(), 0);
  for (const int first : m_window) {
    if (m_kind[first] == Kind::NONE || done[first]) continue;
    if (m_kind[first] == Kind::TURNS || m_model.neighbors.empty())
      chosen.push_back(first);
    else if (Dim == 2)
      chosen.push_back(worst_of_run(first, severity, done));
    else if (is_worst_nearby(first, severity))
      chosen.push_back(first);
  }
  return chosen;
}

// A patch of a surface has as many nodes as its row has, squared: one of it a pass would take as many passes.
template <int Dim>
bool PassChoice<Dim>::is_worst_nearby(int candidate, const std::vector<double>& severity) const {
  for (const int next : m_model.neighbors[candidate]) {
    if (m_kind[next] != m_kind[candidate]) continue;
    if (severity[next] > severity[candidate] || (severity[next] == severity[candidate] && next < candidate))
      return false;
  }
  return true;
}

template <int Dim>
int PassChoice<Dim>::worst_of_run(int first, const std::vector<double>& severity,
                                  std::vector<char>& done) const {
  std::vector<int> run(1, first);
  done[first] = 1;
  int worst = first;
  for (std::size_t k = 0; k < run.size(); ++k)
    for (const int next : m_model.neighbors[run[k]]) {
      if (m_kind[next] != m_kind[first] || done[next]) continue;
      done[next] = 1;
      run.push_back(next);
      if (severity[next] > severity[worst]) worst = next;
    }
  return worst;
}

template <int Dim> bool PassChoice<Dim>::seen_before(const ContactState<Dim>& state) {
  std::vector<char> key;
  for (const int i : m_window) {
    const ContactNode<Dim>& node = state.nodes[i];
    key.push_back(static_cast<char>(in_contact(node.state) ? 1 + sticks(node.state) + 2 * node.tied : 0));
    for (const double d : node.slip_direction) key.push_back(static_cast<char>(std::lround(4 * d)));
  }
  return !m_seen.insert(std::move(key)).second;
}

template <int Dim>
void PassChoice<Dim>::choose(const ContactState<Dim>& before, const std::vector<double>& severity,
                             ContactState<Dim>& trial) {
  for (const int i : m_window) m_kind[i] = kind_of(before.nodes[i], trial.nodes[i]);
  std::vector<int> chosen = worst_of(severity);
  if (seen_before(before)) m_alone = ALONE;
  if (m_alone > 0 && !chosen.empty()) {
    --m_alone;
    std::stable_sort(chosen.begin(), chosen.end(), [&](int a, int b) { return severity[a] > severity[b]; });
    chosen = {chosen[drawn(m_draw) % chosen.size()]};
  }
  std::vector<char> made(m_kind.size(), 0);
  for (const int i : chosen) made[i] = 1;
  for (const int i : m_window)
    if (!made[i]) trial.nodes[i] = before.nodes[i];
}

template class PassChoice<2>;
template class PassChoice<3>;

} // namespace burnish
