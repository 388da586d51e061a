#pragma once
// What every entry of the plugin shares: handles for script variables, the error frame, argument checks.
#include "base/error.hpp"
#include "base/file_error.hpp"
#include "base/memory_limit.hpp"
#include <Eigen/Dense>

#include "ff++.hpp"

#include "AFunction_ext.hpp" // after ff++.hpp

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace burnish {

/// Text of the last error, until rcLastError() takes it.
std::string& last_error();
/// The same whether it has been taken or not, for the other processes.
std::string& latest_error();
constexpr int BAD_INPUT = 20, NOT_WRITTEN = 5; // exit status
/// Error that the script sees once, with its line; exit code 20 unless another is given; text kept for rcLastError().
struct PluginError : Error {
  explicit PluginError(const std::string& message, int status = BAD_INPUT)
      : Error(NONE, "burnish: ", message.c_str()), m_status(status) {
    last_error() = latest_error() = message;
  }
  int errcode() const override { return m_status; }

private:
  int m_status;
};

/// Whether Ctrl-C, SIGTERM or SIGHUP came since rcCatchInterrupt, to one of the ranks; all of them ask.
bool interrupt_came();
/// Whether it came so long ago that a step is not waited for any more; all ranks ask.
bool interrupt_is_old();
/// Whether a run looks at it, between rcCatchInterrupt and rcReleaseInterrupt.
bool run_catches_interrupt();

/// Runs f; turns every std::exception into a PluginError.
template <class F> auto guarded(F&& f) -> decltype(f()) {
  try {
    return f();
  } catch (const Error&) {
    throw;
  } catch (const FileError& e) {
    throw PluginError(e.what(), NOT_WRITTEN);
  } catch (const std::bad_alloc&) {
    throw PluginError("out of memory: " + memory_left_in_words());
  } catch (const std::exception& e) {
    throw PluginError(e.what());
  }
}

/// Runs f; its errors bear the name that the script called instead of the core's. A place (x of
/// tool "crank" ...) stays.
template <class F> auto called(const char* where, F&& f) -> decltype(f()) {
  try {
    return f();
  } catch (const ArgumentError& e) {
    throw ArgumentError(where, e.said());
  } catch (const std::invalid_argument& e) {
    throw ArgumentError(where, e.what());
  }
}

/// Script variables are handles on shared objects.
template <class T> struct Handle {
  std::shared_ptr<T>* p;
  bool destroyed; // by the end of a function that took it by value: FreeFEM hands over the caller's own
  void init() {
    p = nullptr;
    destroyed = false;
  }
  void destroy() {
    destroyed = p != nullptr;
    delete p;
    p = nullptr;
  }
  T& get() const {
    const std::string type = T::TYPE;
    if (!p && destroyed)
      throw PluginError("this " + type +
                        " was destroyed by a function that took it by value; declare its parameter as " +
                        type + " & with a name");
    if (!p) throw PluginError(type + " used before its construction");
    return **p;
  }
  std::shared_ptr<T> share() const {
    get();
    return *p;
  }
  void set(std::shared_ptr<T> object) { p = new std::shared_ptr<T>(std::move(object)); }
};

/// What a maker function returns (`contact C = rcContact(Vh, ...)`: FreeFEM's grammar has no fespace among
/// the arguments of a declaration); the declaration shares the object, FreeFEM frees this one after the statement.
template <class T> struct Made { std::shared_ptr<T>* p; };
template <class T> Made<T> made(Stack stack, std::shared_ptr<T> object) {
  return {Add2StackOfPtr2Free(stack, new std::shared_ptr<T>(std::move(object)))};
}
template <class T> Handle<T>* take_over(Handle<T>* const& handle, const Made<T>& object) {
  handle->init();
  handle->set(*object.p);
  return handle;
}

/// A method `object.name(...)`: the dot gives this proxy, the parenthesis acts on it. Tag makes the type
/// unique.
template <class Object, class Tag> struct Method {
  Object* object;
  Object* operator->() const { return object; }
};
template <class Object, class Tag> Method<Object, Tag> method(Object* const& object) { return {object}; }

/// Registers `type.name(args)`; each maker returns an operator whose first argument is the proxy (made only
/// after the proxy's type is known to FreeFEM).
template <class Object, class Tag, class... Makers> void add_method(const char* name, Makers... makers) {
  using Proxy = Method<Object, Tag>;
  Dcl_Type<Proxy>();
  Add<Object*>(name, ".", new OneOperator1_<Proxy, Object*>(method<Object, Tag>));
  (Add<Proxy>("(", "", makers()), ...);
}

/// Copy of a script array as it is, for entries of the core that name the place of a value that is not finite.
Eigen::VectorXd values_of(const KN_<double>& a);
/// Copy of a script array; refuses NaN and Inf with the place.
Eigen::VectorXd to_vector(const KN_<double>& a, const char* where, const char* name);
/// The same; refuses another size than n, the number of degrees of freedom.
Eigen::VectorXd to_dofs(const KN_<double>& a, long n, const char* where, const char* name);
void to_array(const Eigen::VectorXd& v, KN_<double> a, const char* where);
/// Array result that FreeFEM frees.
KN_<double> new_array(Stack stack, const double* data, std::size_t n);
inline KN_<double> new_array(Stack stack, const std::vector<double>& v) {
  return new_array(stack, v.data(), v.size());
}
inline KN_<double> new_array(Stack stack, const Eigen::VectorXd& v) {
  return new_array(stack, v.data(), static_cast<std::size_t>(v.size()));
}
string* new_string(Stack stack, const std::string& text);

// Registration of each file's part, in this order.
void register_tool();
void register_tool_shapes();
void register_tool_stiffness();
void register_material();
void register_material_data();
void register_material_points();
void register_contact();
void register_contact_step();
void register_point_events();
void register_point_damage();
void register_contact_matrix();
void register_contact_data();
void register_contact_events();
void register_contact_tools();
void register_contact_forces();
void register_contact_findings();
void register_contact_supports();
void register_solver();
void register_geo_mesh();
void register_tools_of_the_trade();
void register_options();
void register_files();
void register_summary();
void register_pictures();
void register_step_control();
void register_checkpoint();
void register_stage();
void register_remesh();
void register_initial_values();

} // namespace burnish
