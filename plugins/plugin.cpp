// load "burnish": registers all types and functions.
#include "plugin.hpp"
#include "base/error.hpp"
#include "callables.hpp"
#include "leave.hpp"
#include "number_list.hpp"
#include "parallel.hpp"
#include "solver/blas_info.hpp"

namespace burnish {

std::string& last_error() {
  static std::string text;
  return text;
}

std::string& latest_error() {
  static auto* const text = new std::string; // the end of the process asks for it
  return *text;
}

Eigen::VectorXd values_of(const KN_<double>& a) {
  Eigen::VectorXd v(a.N());
  for (long i = 0; i < a.N(); ++i) v[i] = a[i];
  return v;
}

Eigen::VectorXd to_vector(const KN_<double>& a, const char* where, const char* name) {
  Eigen::VectorXd v = values_of(a);
  for (long i = 0; i < a.N(); ++i) {
    if (std::isfinite(v[i])) continue;
    std::ostringstream text;
    text << name << "[" << i << "] = " << v[i] << ", expected a finite number";
    fail(where, text.str());
  }
  return v;
}

Eigen::VectorXd to_dofs(const KN_<double>& a, long n, const char* where, const char* name) {
  require(a.N() == n, where, (std::string("size of ") + name).c_str(), a.N(),
          (std::to_string(n) + ", the number of degrees of freedom").c_str());
  return to_vector(a, where, name);
}

void to_array(const Eigen::VectorXd& v, KN_<double> a, const char* where) {
  require(a.N() == v.size(), where, "size of the array", a.N(),
          ("an array of " + std::to_string(v.size())).c_str());
  for (long i = 0; i < a.N(); ++i) a[i] = v[i];
}

KN_<double> new_array(Stack stack, const double* data, std::size_t n) {
  auto* r = Add2StackOfPtr2FreeRC(stack, new KN<double>(static_cast<long>(n)));
  for (long i = 0; i < static_cast<long>(n); ++i) (*r)[i] = data[i];
  return *r;
}

string* new_string(Stack stack, const std::string& text) {
  return Add2StackOfPtr2Free(stack, new string(text));
}

static void init() {
  take_blas_kernels();
  join_ranks();
  register_end();
  note_names_before();
  register_number_list();
  register_tool();
  register_tool_shapes();
  register_tool_stiffness();
  register_material();
  register_material_data();
  register_material_points();
  register_contact();
  register_contact_step();
  register_point_events();
  register_point_damage();
  register_contact_matrix();
  register_contact_data();
  register_contact_events();
  register_contact_tools();
  register_contact_forces();
  register_contact_findings();
  register_contact_supports();
  register_solver();
  register_geo_mesh();
  register_tools_of_the_trade();
  register_options();
  register_step_control();
  register_checkpoint();
  register_stage();
  register_remesh();
  register_initial_values();
  register_files();
  register_pictures();
  register_summary();
  register_callables();
}

} // namespace burnish

LOADFUNC(burnish::init)
