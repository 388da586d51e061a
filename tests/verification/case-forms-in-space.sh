#!/usr/bin/env bash
# -forms 1 of a case in space: the law of the script, by varfs on tetrahedra and by the assembly of the core, takes the steps of the
# core's law and ends where it ends, with FreeFEM's solvers, too.
set -u
run() { # folder, options
  local out=$SCRATCH/$1
  shift
  "$BURNISH" cases/ball/ball.edp -what yield -n 2 -steps 4 -series 0 -pictures 0 -check 0 -out "$out" "$@" >"$out.txt" 2>&1
  case $? in 0 | 4) ;; *) echo "FAILED: $*"; tail -5 "$out.txt"; exit 1 ;; esac
}
run core
run forms -forms 1 -solver CHOLMOD
run assembled -forms 1 -assembly core
"$PYTHON" - "$SCRATCH" <<'END'
import csv, sys
def history(name):
    with open(f"{sys.argv[1]}/{name}/history.csv", encoding="utf-8") as file:
        return list(csv.DictReader(file))
core, wrong = history("core"), 0
for name in ("forms", "assembled"):
    own = history(name)
    same = len(own) == len(core) and all(a["t"] == b["t"] for a, b in zip(own, core))
    worst = max(abs(float(a[k]) - float(b[k])) / max(abs(float(c[k])) for c in core)
                for a, b in zip(own, core) for k in ("z", "Q_z", "stress_eq_max"))
    print(f"{name}: {len(own)} lines of history, {len(core)} by the core, apart by {worst:.1e}")
    wrong += not same or worst > 1e-4
flows = max(float(line["plastic_strain_eq_max"]) for line in core)
print(f"largest plastic strain {flows}")
sys.exit(wrong > 0 or flows == 0)
END
