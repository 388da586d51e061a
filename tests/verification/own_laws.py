"""The laws of edp/manual/examples/law-*.edp on one block pressed flat in plane strain between smooth planes, against exact answers.

own_laws.py FOLDER takes of each example all that stands before its supports (the law and its forms), on 2 x 2 cells, and presses the
block by 5 % (15 % of soil, which is softer) in 100 steps. Its stress is uniform and one of its principal values zero, so that the flow leaves the thickness where
flow and elasticity have come to rest: s_zz = 0 for flow without volume, and |s_yy| = 2/sqrt(3) q. The stress of flow q is a formula of
the plastic strain, the rate, or the mean stress. Compared at the end: |s_yy| to 1e-3, that which is left of the elastic part.
law-in-space.edp runs on a coarse mesh, by rcCondensedRunLaw and by its own loop: the same depth and turn."""
import math
import os
import re
import subprocess
import sys

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TOLERANCE, SLAB = 1e-3, 2 / math.sqrt(3)
SCENE = """
varf sides([a, b], [p, r]) = on(1, b=1) + on(4, a=1);
real[int] held = sides(0, Vh, tgv=1);
tool plane(line=[3, 0, -3, 0], name="plane");
plane.coordinates("cartesian");
plane.place("y", 1.1);
contact C = rcContact(Vh, label=3, fixed=held, friction=0.);
C.add(plane);
real y0 = C.approach(plane, "y", u[]);
func int program(real t) { plane.move("y", y0 - STRAIN*t); plane.move("x", 0); plane.move("angle", 0); return 0; }
func int record(real t) { return 0; }
RUN
real width = 1 + u(1, 0.5);
cout.precision(12);
cout << "law " << abs(plane.force("y"))/width << " " << ep[].max << " " << width << endl;
"""


def pressed(name, folder, options, strain):
    """|s_yy|, plastic strain, width at the end."""
    with open(os.path.join(TOP, "edp/manual/examples", f"law-{name}.edp"), encoding="utf-8") as file:
        text = file.read()
    law = re.sub(r"square\([^;]*;", "square(2, 2);", text[:text.index("varf bottom")], count=1)
    run = ("stepcontrol S(1., dtmax=0.01, stepsperwidth=0);\nrcRunLaw(C, M, u[], S, program, record, law)" if "rcRunLaw" in text
           else "rcCondensedRunLaw(C, Vh, u[], 1., 0.01, program, record, law)")
    script = os.path.join(folder, f"{name}.edp")
    with open(script, "w", encoding="utf-8") as file:
        file.write(law + SCENE.replace("RUN", run).replace("STRAIN", str(strain)))
    done = subprocess.run([os.environ["BURNISH"], script, *options.split()], capture_output=True, text=True, check=False)
    found = re.search(r"^law (\S+) (\S+) (\S+)$", done.stdout, re.M)
    if not found or done.returncode not in (0, 4):
        sys.exit(f"{name} {options}: exit status {done.returncode}\n{done.stdout[-1500:]}{done.stderr[-1500:]}")
    return [float(x) for x in found.groups()]


def voce_and_back_stress(ep):
    """Voce's stress of flow and the back stress of Armstrong and Frederick in monotone flow, C/gamma (1 - exp(-gamma ep))."""
    return 120 + 60 * (1 - math.exp(-20 * ep)) + 3000 / 50 * (1 - math.exp(-50 * ep))


def soil(A, B, k):
    """|s_yy| of q + A p = k where the plastic strain across the plane vanishes: s_zz = -2/9 B q, s_xx = -p; by bisection for q."""
    def stresses(q):
        return (k - q) / A, -2 / 9 * B * q
    def rest(q):
        p, zz = stresses(q)
        return math.sqrt(1.5 * (p * p + (p - zz)**2 + zz * zz)) - q
    low, high = k, 100 * k
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if (rest(middle) < 0) == (rest(low) < 0) else (low, middle)
    p, zz = stresses(low)
    return abs(2 * p - zz)


def in_space(folder):
    """Depth and turn of law-in-space.edp on a coarse mesh, by the run of the core and by the loop of the script."""
    with open(os.path.join(TOP, "edp/manual/examples/law-in-space.edp"), encoding="utf-8") as file:
        text = re.sub(r"cube\([^;]*;", "cube(4, 3, 2, [0.8*x - 0.35, 0.6*y - 0.3, 0.4*(z - 1)]);", file.read(), count=1)
    text = text.replace("friction=0.2", "friction=0.2, tolerance=1e-5").replace("0.1, program", "0.125, program").replace("dtmax=0.1", "dtmax=0.125")
    script = os.path.join(folder, "space.edp")
    with open(script, "w", encoding="utf-8") as file:
        file.write(text)
    found = []
    for loop in ("0", "1"):
        done = subprocess.run([os.environ["BURNISH"], script, "-loop", loop], capture_output=True, text=True, check=False)
        numbers = re.search(r"^depth (\S+) mm, turned (\S+) rad", done.stdout, re.M)
        if not numbers or done.returncode not in (0, 4):
            sys.exit(f"law-in-space -loop {loop}: exit status {done.returncode}\n{done.stdout[-1500:]}{done.stderr[-1500:]}")
        found.append([float(x) for x in numbers.groups()])
    return found


def main(folder):
    # of the plastic strain, 1/s: the stress rises by hardening, and with it the elastic strain
    rate = SLAB * 0.05 / (1 + SLAB**2 * 500 * (1 - 0.33**2) / 7e4)
    bulk = 7e4 / 3 / (1 - 2 * 0.33)

    def hard(ep):
        return SLAB * (150 + 500 * ep)
    wanted = (("j2", "", 0.05, hard), ("j2-arrays", "", 0.05, hard), ("perzyna", "", 0.05, lambda ep: hard(ep) + SLAB * 500 * rate), ("perzyna", "-eta 1e-6", 0.05, hard),
              ("cyclic", "", 0.05, lambda ep: SLAB * voce_and_back_stress(ep)),
              ("soil", "", 0.15, lambda ep: soil(0.8, 0, 0.5)), ("soil", "-B 0.4", 0.15, lambda ep: soil(0.8, 0.4, 0.5)),
              ("finite", "", 0.05, lambda ep: hard(ep) / (1 - hard(ep) / 2 / bulk)))   # Kirchhoff's over det F
    wrong = 0
    for name, options, strain, answer in wanted:
        stress, ep, width = pressed(name, folder, options, strain)
        if name != "finite":                                  # small strains: force over the width at the start
            stress *= width
        error = stress / answer(ep) - 1
        wrong += abs(error) > TOLERANCE
        print(f"law-{name} {options}: {stress:.6g} MPa, expected {answer(ep):.6g}, off by {error:.1e}, plastic strain {ep:.5f}")
    run, loop = in_space(folder)
    apart = max(abs(b / a - 1) for a, b in zip(run, loop))
    wrong += apart > TOLERANCE
    print(f"law-in-space: depth {run[0]}, turn {run[1]}, its own loop is off by {apart:.1e}")
    sys.exit(wrong > 0)


main(sys.argv[1])
