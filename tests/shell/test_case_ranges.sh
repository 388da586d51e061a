#!/usr/bin/env bash
# Geometry and ranges of every case's options are checked before anything is meshed: each of these is refused within
# seconds, with exit status 20 and a message that names the option, and makes no file.
set -u
failures=0
# case OPTIONS, one line each
while read -r name options; do
  case $name in '' | '#'*) continue ;; esac
  read -ra words <<<"$options"
  output=$(timeout 20 "$BURNISH" "cases/$name/$name.edp" -out "$SCRATCH/$name" "${words[@]}" 2>&1 </dev/null)
  status=$?
  grep -qE "option.*${words[0]}\b" <<<"$output" && [ "$status" = 20 ] && [ ! -e "$SCRATCH/$name" ] && continue
  echo "FAILED: $name $options: exit status $status"
  tail -n 3 <<<"$output"
  failures=$((failures + 1))
done <<'END'
rolling -outer 1e9
rolling -Ri -1
rolling -Ri 0.03
rolling -sector 0
rolling -R 0
rolling -width 1e300
rolling -mu nan
rolling -tolerance 0.1
rolling -steps 1e9
rolling -series -1
punch -n 1000000000
punch -size 1e12
bending -nx 0
bending -dieangle 200
cam -n -3
cam -left 2
cam -W 1e-300
cam -W 1e-9
crank-press -n -3
crank-press -W -1
cyclic -n 1000000
cyclic -B 0
damage -a 1e-9
damage -left 2
hertz -n 0
hertz -a -1
incline -nx 0
incline -length 0
indentation -fine 1000000
indentation -B -1
partial-slip -n 0
partial-slip -R 0
planetary -fine 1e-12
planetary -Ro 1e9
roll-bending -angle 10
roll-bending -press -1
roll-bending -length 20
rolling-contact -n 0
rolling-contact -a inf
rubber -n 0
rubber -way 1e15
shear -G 0
spring-roller -n -3
spring-roller -way 1e9
step-die -fine 1e-9
step-die -draft 90
strip-rolling -ny 0
strip-rolling -h0 0
u-channel -size 1e-12
cup -size 1e-12
leveller -rolls 4
leveller -way 80
leveller -drive pulled
leveller -ny 0
cup -ny -3
cup -nose 21
cup -blank 26
u-channel -ny -3
upsetting -n 0
upsetting -a 0
plate-rolling -h1 2
plate-rolling -drive up
plate-rolling -ratio -1e300
ring-rolling -r 26
ring-rolling -draft 8
END
echo "$failures failed"
[ "$failures" = 0 ]
