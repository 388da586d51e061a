#pragma once
// The list of what the plugin registers.

namespace burnish {

/// Before the first registration: global names that are not ours.
void note_names_before();
/// After the last one.
void register_callables();

} // namespace burnish
