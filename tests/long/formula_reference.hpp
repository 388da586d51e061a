#pragma once
// A formula read and evaluated independently of the core: recursive descent, long double, first and second
// derivatives carried along by the chain rule. Variables x and y. Throws std::runtime_error for wrong syntax.
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace reference {

using Real = long double;

/// The larger one, NaN if one of them is.
inline Real larger(Real a, Real b) { return std::isnan(a) || a > b ? a : b; }

/// Value and derivatives by x and y, and the largest of the like on the way to it.
struct Jet {
  Real f = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, largest = 0;
  bool varies = false; ///< x or y is in the text of it

  bool finite() const { return std::isfinite(f + x + y + xx + xy + yy) && std::isfinite(largest); }
  Jet noted(Real before) const {
    Jet jet = *this;
    jet.largest = larger(largest, before);
    for (const Real part : {f, x, y, xx, xy, yy}) jet.largest = larger(jet.largest, std::fabs(part));
    if (!std::isfinite(f + x + y + xx + xy + yy)) jet.largest = NAN;
    return jet;
  }
  /// g(this) from g, g', g'' at f.
  Jet chain(Real g, Real g1, Real g2) const {
    return Jet{g, g1 * x, g1 * y, g2 * x * x + g1 * xx, g2 * x * y + g1 * xy, g2 * y * y + g1 * yy, 0, varies}
        .noted(larger(largest, larger(std::fabs(g1), std::fabs(g2))));
  }
};

inline Jet plus(const Jet& a, const Jet& b, Real sign) {
  return Jet{a.f + sign * b.f,
             a.x + sign * b.x,
             a.y + sign * b.y,
             a.xx + sign * b.xx,
             a.xy + sign * b.xy,
             a.yy + sign * b.yy,
             0,
             a.varies || b.varies}
      .noted(larger(a.largest, b.largest));
}
inline Jet times(const Jet& a, const Jet& b) {
  return Jet{a.f * b.f,
             a.x * b.f + a.f * b.x,
             a.y * b.f + a.f * b.y,
             a.xx * b.f + 2 * a.x * b.x + a.f * b.xx,
             a.xy * b.f + a.x * b.y + a.y * b.x + a.f * b.xy,
             a.yy * b.f + 2 * a.y * b.y + a.f * b.yy,
             0,
             a.varies || b.varies}
      .noted(larger(a.largest, b.largest));
}
inline Jet inverse(const Jet& a) { return a.chain(1 / a.f, -1 / (a.f * a.f), 2 / (a.f * a.f * a.f)); }
inline Jet logarithm(const Jet& a) { return a.chain(std::log(a.f), 1 / a.f, -1 / (a.f * a.f)); }
inline Jet raised(const Jet& a, Real n) {
  if (a.f == 0 && n <= 0) n = NAN; // no value
  return a.chain(std::pow(a.f, n), n == 0 ? 0 : n * std::pow(a.f, n - 1),
                 n == 0 || n == 1 ? 0 : n * (n - 1) * std::pow(a.f, n - 2));
}
inline Jet exponential(const Jet& a) {
  const Real e = std::exp(a.f);
  return a.chain(e, e, e);
}
inline Jet power(const Jet& a, const Jet& b) {
  return b.varies ? exponential(times(b, logarithm(a))) : raised(a, b.f).noted(larger(a.largest, b.largest));
}
inline Jet arc(const Jet& y,
               const Jet& x) { // atan2: any branch has the derivatives of atan(y/x) or -atan(x/y)
  const bool steep = std::fabs(y.f) > std::fabs(x.f);
  const Jet t = steep ? times(x, inverse(y)) : times(y, inverse(x));
  const Real q = 1 + t.f * t.f, sign = steep ? -1 : 1;
  Jet result = t.chain(sign * std::atan(t.f), sign / q, -2 * sign * t.f / (q * q));
  result.f = std::fabs(y.f) < 1e-12L && x.f < 0 ? NAN : std::atan2(y.f, x.f); // on the cut rounding decides
  return result.noted(result.largest);
}

/// Both branches must have a value, and the condition must be clear of zero: rounding decides there.
inline Jet taken(const Jet& c, const Jet& a, const Jet& b) {
  Jet result = (c.f > 0 ? a : b).noted(larger(a.largest, b.largest));
  result.varies = a.varies || b.varies || c.varies;
  if (!(std::fabs(c.f) >= 1e-9L) || !a.finite() || !b.finite()) result.largest = NAN;
  result.largest = larger(result.largest, c.largest);
  return result;
}

/// Functions of one argument: value, first and second derivative.
inline Jet called(const std::string& name, const Jet& a) {
  const Real u = a.f, s = std::sin(u), c = std::cos(u), sh = std::sinh(u), ch = std::cosh(u);
  if (name == "sin") return a.chain(s, c, -s);
  if (name == "cos") return a.chain(c, -s, -c);
  if (name == "tan") return a.chain(s / c, 1 / (c * c), 2 * s / (c * c * c));
  if (name == "sinh") return a.chain(sh, ch, sh);
  if (name == "cosh") return a.chain(ch, sh, ch);
  if (name == "tanh") return a.chain(sh / ch, 1 / (ch * ch), -2 * sh / (ch * ch * ch));
  if (name == "exp") return exponential(a);
  if (name == "log") return logarithm(a);
  if (name == "sqrt") return raised(a, 0.5L);
  if (name == "atan") return a.chain(std::atan(u), 1 / (1 + u * u), -2 * u / ((1 + u * u) * (1 + u * u)));
  const Real in = 1 - u * u, out = u * u - 1, up = 1 + u * u;
  if (name == "asin") return a.chain(std::asin(u), 1 / std::sqrt(in), u / std::pow(in, 1.5L));
  if (name == "acos") return a.chain(std::acos(u), -1 / std::sqrt(in), -u / std::pow(in, 1.5L));
  if (name == "asinh") return a.chain(std::asinh(u), 1 / std::sqrt(up), -u / std::pow(up, 1.5L));
  if (name == "acosh") return a.chain(std::acosh(u), 1 / std::sqrt(out), -u / std::pow(out, 1.5L));
  if (name == "atanh") return a.chain(std::atanh(u), 1 / in, 2 * u / (in * in));
  // no derivative at the jump; a jump nearby makes the comparison meaningless
  const Real jump = !(std::fabs(u) >= 1e-9L) ? NAN : (u > 0) - (u < 0);
  if (name == "abs") return a.chain(std::fabs(u), jump, 0);
  if (name == "sign") return a.chain(jump, 0, 0);
  if (name == "step") return a.chain((1 + jump) / 2, 0, 0);
  throw std::runtime_error("unknown function " + name);
}

class Parser {
public:
  Parser(std::string text, Real x, Real y) : m_text(std::move(text)), m_x(x), m_y(y) {}
  Jet result() {
    const Jet jet = sum();
    if (next() != '\0' || m_at < m_text.size()) throw std::runtime_error("more text");
    return jet;
  }

private:
  char next() {
    while (m_at < m_text.size() && std::string(" \t\n\r\f\v").find(m_text[m_at]) != std::string::npos) ++m_at;
    return m_at < m_text.size() ? m_text[m_at] : '\0';
  }
  bool take(char c) {
    if (m_at >= m_text.size() || next() != c) return false;
    ++m_at;
    return true;
  }
  void expect(char c) {
    if (!take(c)) throw std::runtime_error(std::string("expected ") + c);
  }
  Jet sum() {
    const bool minus = take('-');
    if (!minus) take('+');
    Jet result = minus ? plus(Jet{}, product(), -1) : product();
    while (next() == '+' || next() == '-') {
      const Real sign = take('+') ? 1 : (take('-'), -1);
      result = plus(result, product(), sign);
    }
    return result;
  }
  Jet product() {
    Jet result = factor();
    while (next() == '*' || next() == '/')
      result = take('*') ? times(result, factor()) : (take('/'), times(result, inverse(factor())));
    return result;
  }
  Jet factor() {
    const Jet base = atom();
    return take('^') ? power(base, atom()) : base;
  }
  Jet atom() {
    if (take('(')) {
      const Jet inside = sum();
      expect(')');
      return inside;
    }
    const char c = next();
    if (std::isdigit(static_cast<unsigned char>(c)) || c == '.') return number();
    std::string word;
    while (m_at < m_text.size() &&
           (std::isalnum(static_cast<unsigned char>(m_text[m_at])) || m_text[m_at] == '_'))
      word += m_text[m_at++];
    if (word == "x") return Jet{m_x, 1, 0, 0, 0, 0, std::fabs(m_x), true};
    if (word == "y") return Jet{m_y, 0, 1, 0, 0, 0, std::fabs(m_y), true};
    if (word == "pi" || word == "Pi") return Jet{std::acos(-1.L), 0, 0, 0, 0, 0, 4, false};
    expect('(');
    std::vector<Jet> a{sum()};
    if (word == "if") a = condition(a[0]);
    while (next() == ',' && take(',')) a.push_back(sum());
    expect(')');
    return call(word, a);
  }
  /// l > r and the like as the number that is above zero where it holds; the sign >= is > but for equality, which is left out.
  std::vector<Jet> condition(const Jet& left) {
    const char sign = next();
    if (!take('<') && !take('>')) return {left};
    if (m_at < m_text.size() && m_text[m_at] == '=') ++m_at;
    const Jet right = sum();
    return {sign == '>' ? plus(left, right, -1) : plus(right, left, -1)};
  }
  static Jet call(const std::string& word, const std::vector<Jet>& a) {
    const std::size_t expected = word == "if"                                                         ? 3
                                 : word == "atan2" || word == "pow" || word == "min" || word == "max" ? 2
                                                                                                      : 1;
    if (a.size() != expected) throw std::runtime_error("arguments of " + word);
    if (word == "if") return taken(a[0], a[1], a[2]);
    if (word == "min") return taken(plus(a[1], a[0], -1), a[0], a[1]);
    if (word == "max") return taken(plus(a[0], a[1], -1), a[0], a[1]);
    return word == "pow" ? power(a[0], a[1]) : word == "atan2" ? arc(a[0], a[1]) : called(word, a[0]);
  }
  Jet number() {
    char* end = nullptr;
    if (const std::size_t hexadecimal = m_text.find_first_of("xX", m_at); hexadecimal != std::string::npos)
      if (hexadecimal == m_at + 1) throw std::runtime_error("no number");
    const Real value = std::strtold(m_text.c_str() + m_at, &end);
    if (end == m_text.c_str() + m_at) throw std::runtime_error("no number");
    m_at = static_cast<std::size_t>(end - m_text.c_str());
    return Jet{value, 0, 0, 0, 0, 0, std::fabs(value), false};
  }

  std::string m_text;
  Real m_x, m_y;
  std::size_t m_at = 0;
};

} // namespace reference
