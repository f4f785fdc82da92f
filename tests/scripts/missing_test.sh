#!/usr/bin/env bash
# missing_test.sh COSIM
#
# Every script on a machine that has what the first command installs and no network: it ends with 0, or
# with 2 and one line that names what is missing; so does one that is to take programs as they are. Builds take no time here: the program COSIM is put
# where it is built, and other programs are stand-ins that need yosys, as theirs do.
# Status: 0 so, 1 not.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
cosim=$(realpath "$1")
tree=$folder/tree bin=$folder/bin
mkdir "$tree" "$bin"
cp -r "$root"/{scripts,rtl,docs,examples,tests,CMakeLists.txt} "$tree"
mkdir -p "$tree/tb/sim" && cp "$root/tb/sim/page.css" "$tree/tb/sim"
unset COSIM_RECORDED COSIM_FAILURES COSIM CXX DISPLAY WAYLAND_DISPLAY "${!CCACHE_@}" "${!CMAKE_@}"

# packages SET...: the packages of these sets, by what setup says where there are none of Debian.
mkdir "$folder/none"
for tool in bash basename dirname; do ln -s "$(command -v "$tool")" "$folder/none"; done
packages() {
  { PATH=$folder/none "$root/scripts/setup" "$@" 2>&1 || (($? == 2)); } |
    sed -n 's/.*needed are: //p' | tr ' ' '\n' | sort -u
}
read -ra sets < <(sed -n '2s/.*\[\(.*\)\].*/\1/p' "$root/scripts/setup" | tr '|' ' ')
packages run > "$folder/run"
packages "${sets[@]}" | comm -13 "$folder/run" - > "$folder/others"
[[ -s $folder/run && -s $folder/others ]] || fails "setup has packages for running, and others"

# All that is on the PATH now, but for the programs of those others.
IFS=: read -ra places <<< "$PATH"
for place in "${places[@]}"; do
  find -L "$place" -maxdepth 1 -type f -executable -exec ln -st "$bin" {} + 2> "$folder/twice" || true
done
# By dpkg where it knows them, and by name where they are built elsewhere.
xargs dpkg-query -L < "$folder/others" 2> "$folder/unknown" | grep -oP '^/usr/s?bin/\K.*' > "$folder/gone" || true
# sudo finds the programs of the whole system.
printf '%s\n' yosys yosys-abc z3 git sudo >> "$folder/gone"
(cd "$bin" && xargs rm -f apt-get apt-cache dpkg-query cmake ctest) < "$folder/gone"

program() { cat > "$bin/$1" && chmod +x "$bin/$1"; }
program apt-get << 'END'
#!/bin/sh
echo "E: no network" >&2
exit 100
END
program apt-cache <<< $'#!/bin/sh\n'
program dpkg-query << END
#!/bin/sh
sed 's/^/installed /' '$folder/run'
END
program cmake << END
#!/usr/bin/env bash
[[ " \$* " != *" -P "* ]] || exec '$(command -v cmake)' "\$@"
[[ \$1 != --build || ! -d \$2 ]] || install -D '$folder/program' "\$2/streams_benchmark"
[[ \$1 != -S ]] || mkdir -p "\$4"
[[ \$* =~ --target\ ([a-z_]+) ]] || exit 0
case \${BASH_REMATCH[1]} in
  cosim) ln -sf '$cosim' '$tree/build/cosim' ;;
  lockstep_benchmark) made=tests/benchmark/lockstep_benchmark ;;
  claims) made=tests/studies/claims/claims ;;
  careless) made=tests/careless/careless ;;
esac
[[ ! \${made-} ]] || install -D '$folder/program' "$tree/build/\$made"
END
cat > "$folder/program" << 'END'
#!/usr/bin/env bash
[[ $0 != */lockstep_benchmark ]] || yosys -V || kill -ABRT $$
for word; do
  [[ $word != --benchmark_out=* ]] || echo '"bare_median",1,1,1,us,,1e6' > "${word#*=}"
done
END

# ends SCRIPT WORDS...: the line that it may end with names a package or a program that is missing.
met=()
names=$(cat "$folder/others" "$folder/gone" <(echo root) | paste -sd '|')
ends() {
  local status=0 lines
  met+=("$1")
  (cd "$tree" && PATH=$bin HOME=$folder timeout -k 5 300 "scripts/$1" "${@:2}") \
    > "$folder/out" 2> "$folder/err" < /dev/null || status=$?
  ((status != 0)) || return 0
  lines=$(grep -vE '^(== |E: )' "$folder/err") || true
  if ((status != 2)) || [[ $lines == *$'\n'* ]] || ! grep -qwE "$names" <<< "$lines"; then
    cat "$folder/out" "$folder/err"
    fails "scripts/$* ends with 0, or with 2 and a line with what is missing; it is $status"
  fi
}

cat > "$folder/plan.json" << 'END'
{"format": 1, "name": "all", "tasks": [
  {"name": "p", "prove": true}, {"name": "f", "fuzz": "build/fuzz/tests/fuzz/fuzz_gcode"}]}
END
read -ra shape < <(grep -m 1 '^[^#]' "$root/rtl/shipped.txt")
design=${shape[0]}
ends setup
ends benchmark
ends benchmark streams
ends careless --cases 1
ends claims
ends commits "$root"
ends pairs
ends cosim list
ends cosim --gates list
ends cover
ends deb
ends examples
ends exhaustive
ends fresh bookworm true
ends fuzz
ends lint
ends models --count 1
mkdir "$folder/modules"
cp "$root/examples/counter/counter.v" "$folder/modules"
ends modules "$folder/modules"
ends mutate
ends mutate --models
ends mutate --drawn
ends netlist
ends netlist --write "$folder/netlist.v" generic "${shape[@]}"
# Without one of the designs of its study there is no command that draws a path.
if "$cosim" --complete path | grep -qx path; then
  ends picture "$root/tests/fuzz/corpus/gcode/head.ngc" 10 "$folder/picture.png"
else
  met+=(picture)
fi
mkdir "$folder/pages"
ends reference --to "$folder/pages" "$cosim"
ends prove
ends prove --faults
ends regress "$folder/plan.json"
ends report
ends site
ends synth
ends test
ends test --all
ends test --slurm
ends wave
ends wave test Any
ends without "$design"

# And what --built takes as it is, where it is not there.
for what in --models --drawn --slice; do
  status=0
  line=$("$root/scripts/mutate" "$what" --built "$folder/none" 2>&1) || status=$?
  [[ $status == 2 && $line == *" is not built there" ]] || fails "mutate $what says what is not built: $line"
done

for script in "$root"/scripts/*; do
  name=$(basename "$script")
  [[ ! -f $script || ! -x $script || " ${met[*]} " == *" $name "* ]] || fails "scripts/$name is tried"
done
echo "each names what it needs"
