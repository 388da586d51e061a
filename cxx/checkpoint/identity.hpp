#pragma once
// What a run must have in common with a checkpoint to go on from it: mesh, tools, material, steps, script, options.
#include "checkpoint/checkpoint.hpp"
#include "run/contact_run.hpp"
#include "run/run_body.hpp"
#include "run/step_control.hpp"
#include "script/options.hpp"

namespace burnish {

/// A mesh, and a material, in words that differ where they do.
template <int Dim> std::string mesh_words(const Mesh<Dim>& mesh);
template <int Dim> std::string material_words(const Workpiece<Dim>& workpiece);

/// Of the scene. @param forms_only nothing is known of the material
template <int Dim>
std::vector<IdentityPart> identity_of(const ContactRun<Dim>& run, const RunBody<Dim>& body,
                                      const StepControlOptions& steps, bool forms_only);

/// Of the script: its text and that of the files that it includes, without comments and empty lines, and the options that change
/// its numbers.
/// @param folders "a;b", where included files are looked for
std::vector<IdentityPart> identity_of(const ScriptOptions& options, const std::string& folders);

} // namespace burnish
