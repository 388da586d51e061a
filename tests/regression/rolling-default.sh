#!/usr/bin/env bash
# Example 1 on the default mesh: what must hold of it (see rolling_default.py).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$BURNISH" cases/rolling/rolling.edp -pictures 2 -out "$SCRATCH/default" >"$SCRATCH/default.log" || { tail -20 "$SCRATCH/default.log"; exit 1; }
"$PYTHON" "$here/rolling_default.py" "$SCRATCH/default"
