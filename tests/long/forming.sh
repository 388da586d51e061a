#!/usr/bin/env bash
# The scenes of tests/support/forming on finer meshes, and a U-bend that snaps from node to node.
exec "$PYTHON" tests/support/forming/check.py long
