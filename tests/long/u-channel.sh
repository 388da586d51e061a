#!/usr/bin/env bash
# U-channel, coarse: punch force, springback and thickness against u-channel.json, balance by the case itself. Then two elements
# through the thickness: implicit and event steps both come to the end, with the same force.
set -eu
"$PYTHON" tests/regression/case.py u-channel
run() { name=$1; shift; "$BURNISH" cases/u-channel/u-channel.edp -pictures 0 -series 0 -out "$SCRATCH/$name" "$@" >"$SCRATCH/$name.log" || [ $? = 4 ]; }
run implicit -ny 2
run event -ny 2 -scheme event
"$PYTHON" - "$SCRATCH" <<'END'
import json, sys
force = {name: json.load(open(f"{sys.argv[1]}/{name}/summary.json")) for name in ("implicit", "event")}
peak = {name: s["results"]["largest punch force, both halves"]["value"] for name, s in force.items()}
ends = {name: s["final"]["t"] for name, s in force.items()}
print(peak, ends)
sys.exit(not (ends == {"implicit": 2, "event": 2} and abs(peak["implicit"] / peak["event"] - 1) < 2e-3))
END
