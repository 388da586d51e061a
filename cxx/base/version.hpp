#pragma once
// Version of the toolkit, as in CHANGELOG.md.
#define BURNISH_VERSION "0.1.0"
