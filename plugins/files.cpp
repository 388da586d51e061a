// Files that are whole or not there. What cannot be written ends the script with exit status 5, unless caught.
//   > { ofstream f(rcNewName(file)); f << ...; rcReplaced(f, file); }    a new content takes the place of the file's
//   > { ofstream f(file, append); f << ...; rcAppended(f, file); }       whole lines at the end of a file
//   rcMakeFolder(path)   makes the folder, checks that it can be written, and keeps other runs out of it until the script ends
//     path      of the folder
//     ! is in use: another run writes to it
//   rcNewName(file)   name that its new content is written under
//     file      path
//   rcReplaced(f, file)   closes f; the new content takes the place of the file's
//     f         the stream of rcNewName(file)
//     file      path
//   rcAppended(f, file)   closes f; keeps whole lines only
//     f         a stream opened with append
//     file      path
//   M.savefields(file)   .vtu file for ParaView: fields of the accepted state on the reference mesh, double precision, whole
//     file      path
//   rcUnits(length, stress)   says in which units the script's numbers are: pictures, movies, pages, summary.json and the files' field
//       data (meters_per_length, pascals_per_stress) have them. No number is converted. Call it before rcCase
//     length    of lengths | | | "m", "cm", "mm", "um"
//     stress    of stresses | | | "Pa", "kPa", "MPa", "GPa"
//     ! rcUnits: unit of
//   C.savesurface(file)   .vtp file: the contact surface with pressure, friction, gap, state
//     file      path
//   C.savetools(file)   .vtp file: outlines of all tools where they are
//     file      path
//   C.savesupports(file)   .vtp file: nodes whose displacement is given
//     file      path
//   S.savestopped()   out/SCRIPT/stopped.vtu, below the folder where FreeFEM runs: fields of the accepted state of a run, of forms
//       without a material the displacement; returns its name
//     ! no run has been started, call start first
//   internal: rcRemoveResults rcRemoveFrames
#include "base/run_folder.hpp"
#include "base/whole_file.hpp"
#include "checkpoint.hpp"
#include "file_units.hpp"
#include "output/contact_files.hpp"
#include "output/workpiece_file.hpp"
#include "script_options.hpp"
#include "step_control.hpp"
#include <csignal>
#include <filesystem>
#include <fstream>

namespace burnish {

FileUnits& units_of_files() {
  static FileUnits units;
  return units;
}

namespace {

bool set_units(string* const& length, string* const& stress) {
  return guarded([&] { return units_of_files() = file_units(*length, *stress), true; });
}

bool make_folder(string* const& path) {
  return guarded([&] { return make_run_folder(*path, "rcMakeFolder"), true; });
}
bool remove_older(string* const& folder) {
  return guarded([&] { return remove_results(*folder), true; });
}
bool remove_later_frames(string* const& folder, const long& last) {
  return guarded([&] { return remove_frames(*folder, last), true; });
}
string* name_of_new(Stack stack, string* const& path) { return new_string(stack, new_name(*path)); }

// Whether all that was written has arrived.
bool closed_well(std::ostream** const& stream) {
  auto* file = dynamic_cast<std::ofstream*>(*stream);
  if (!file) return false;
  file->close();
  return file->good();
}
bool replaced(std::ostream** const& stream, string* const& path) {
  return guarded([&] { return replace_file(*path, closed_well(stream)), true; });
}
bool appended(std::ostream** const& stream, string* const& path) {
  return guarded(
      [&] { return keep_whole_lines(*path, closed_well(stream)), growing_paths().insert(*path), true; });
}

struct SaveTag {};
struct SurfaceTag {};
struct ToolsTag {};
struct SupportsTag {};
bool save_fields_of(const Method<MaterialHandle, SaveTag>& m, string* const& path) {
  return on(m.object,
            [&](auto& material) { return save_fields(material.workpiece(), *path, units_of_files()), true; });
}
bool save_surface_of(const Method<ContactHandle, SurfaceTag>& m, string* const& path) {
  return on(m.object, [&](auto& contact) { return save_surface(contact.run(), *path), true; });
}
bool save_supports_of(const Method<ContactHandle, SupportsTag>& m, string* const& path) {
  return on(m.object, [&](auto& contact) { return save_supports(contact.run(), *path), true; });
}
bool save_tools_of(const Method<ContactHandle, ToolsTag>& m, string* const& path) {
  return on(m.object, [&](auto& contact) {
    const Eigen::VectorXd none;
    return save_tools(*contact.setup, contact.started() ? contact.run().accepted().u : none, *path), true;
  });
}

struct StoppedTag {};
string* save_stopped(Stack stack, const Method<StepControlHandle, StoppedTag>& m) {
  return guarded([&] {
    const ControlObject& run = m->get();
    constexpr const char* WHERE = "stepcontrol.savestopped";
    run.running(WHERE);
    namespace fs = std::filesystem;
    const fs::path file = "out" / fs::path(script_options().script()).stem() / "stopped.vtu";
    std::error_code unmade; // is told when the file is written
    fs::create_directories(file.parent_path(), unmade);
    visit(*run.contact, [&](auto& contact) {
      const auto& body = of_dimension<dim_of<decltype(contact)>>(*run.material, WHERE).workpiece();
      if (run.options.forms_only)
        save_displacement(body.discretization(), contact.run().accepted().u, file.string());
      else
        save_fields(body, file.string(), units_of_files());
    });
    return new_string(stack, file.string());
  });
}

} // namespace

void register_files() {
  std::signal(SIGXFSZ, SIG_IGN); // a file at the limit of its size is an error of writing it
  Global.Add("rcUnits", "(", new OneOperator2_<bool, string*, string*>(set_units));
  Global.Add("rcMakeFolder", "(", new OneOperator1_<bool, string*>(make_folder));
  Global.Add("rcRemoveResults", "(", new OneOperator1_<bool, string*>(remove_older));
  Global.Add("rcRemoveFrames", "(", new OneOperator2_<bool, string*, long>(remove_later_frames));
  Global.Add("rcNewName", "(", new OneOperator1s_<string*, string*>(name_of_new));
  Global.Add("rcReplaced", "(", new OneOperator2_<bool, std::ostream**, string*>(replaced));
  Global.Add("rcAppended", "(", new OneOperator2_<bool, std::ostream**, string*>(appended));
  add_method<MaterialHandle, SaveTag>("savefields", [] {
    return new OneOperator2_<bool, Method<MaterialHandle, SaveTag>, string*>(save_fields_of);
  });
  add_method<StepControlHandle, StoppedTag>("savestopped", [] {
    return new OneOperator1s_<string*, Method<StepControlHandle, StoppedTag>>(save_stopped);
  });
  add_method<ContactHandle, SurfaceTag>("savesurface", [] {
    return new OneOperator2_<bool, Method<ContactHandle, SurfaceTag>, string*>(save_surface_of);
  });
  add_method<ContactHandle, SupportsTag>("savesupports", [] {
    return new OneOperator2_<bool, Method<ContactHandle, SupportsTag>, string*>(save_supports_of);
  });
  add_method<ContactHandle, ToolsTag>("savetools", [] {
    return new OneOperator2_<bool, Method<ContactHandle, ToolsTag>, string*>(save_tools_of);
  });
}

} // namespace burnish
