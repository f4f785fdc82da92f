#!/usr/bin/env bash
# What a script leaves by record(), and the page that scripts/report makes of it, on a small tree:
# what passed, what failed, what could not run, what was not run, what is older than the sources, and
# the failures that were kept. Status: 0 so, 1 not.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
tree=$folder
unset COSIM_RECORDED COSIM_FAILURES

mkdir -p "$tree"/{scripts,model,rtl,tests,examples,tb/sim}
cp "$root"/scripts/{lib.sh,report} "$tree/scripts"
cp "$root/tb/sim/page.css" "$tree/tb/sim"
touch "$tree/CMakeLists.txt"
# script NAME TITLE LINES: a script that is recorded.
# shellcheck disable=SC2016 # its lines are its own
script() {
  printf '#!/usr/bin/env bash\nsource "$(dirname "$0")/lib.sh"\nrecord %s "%s" "scripts/%s"\n%s\n' \
    "$1" "$2" "$1" "$3" > "$tree/scripts/$1"
  chmod +x "$tree/scripts/$1"
}
# shellcheck disable=SC2016
script good "Good <one>" 'echo "got $#: $1 <&>"; "$root/scripts/inner"'
script inner "Inner" 'echo inside'
script bad "Bad one" 'echo worse; exit 1'
script cannot "Cannot" 'exit 2'
script never "Never" 'true'
sed -i 's/^record/(($#)) || record/' "$tree/scripts/never" # where it is not recorded always
find "$tree" -exec touch -d '1 hour ago' {} +

has() { grep -qF -- "$1" "$tree/build/report/index.html" || fails "the page has: $1"; }
has_not() { ! grep -qF -- "$1" "$tree/build/report/index.html" || fails "the page has not: $1"; }
ends() {
  local wanted=$1 status=0
  shift
  "$@" > "$tree/said" 2>&1 || status=$?
  [[ $status == "$wanted" ]] || fails "$* ends with $wanted, not $status"
}

cd "$tree"
ends 0 scripts/report
has '0 failed, 0 passed, 6 not run'
has '<code>scripts/never</code>'

ends 0 scripts/good 'two words'
grep -qxF 'got 1: two words <&>' said || fails "what is recorded is printed"
ends 1 scripts/bad
ends 2 scripts/cannot
mkdir -p failures/first-case
printf 'first, a case\nfirst difference: clock 7, x\n' > failures/first-case/report.txt
touch failures/first-case/report.html
ends 0 scripts/report
has '2 failed, 1 passed, 3 not run'
has 'Good &lt;one&gt;'
has 'got 1: two words &lt;&amp;&gt;'
has 'inside'
has '<code>scripts/good two words</code>'
has '>FAILED<'
has '>could not run<'
has 'first difference: clock 7, x'
has 'href="../../failures/first-case/report.html"'
has 'None is older than the sources'
has_not '<script'
[[ ! -e build/results/inner ]] || fails "what runs below another one belongs to that"
[[ $(find build/results -name '.*' -type f) == '' ]] || fails "nothing half is left"

# A source that is changed later.
touch -d '1 hour' tb/changed.cpp
ends 0 scripts/report
has '<b class="old">Older than the sources</b>: 3, to be run again.'
has '1 file since, tb/changed.cpp last'

# The newest regression that ended, from what is in its folder.
mkdir -p regressions/{old,new,running}
for run in regressions/*; do echo '{}' > "$run/plan.json"; done
printf 'old: all run\nverdict: fail\n' > regressions/old/report.txt
touch -d '10 minutes ago' regressions/old/*
touch -d '2 minutes ago' regressions/new/plan.json
printf 'new: 2 tasks, all run\nverdict: pass\n' > regressions/new/report.txt
ends 0 scripts/report
has '2 failed, 2 passed, 2 not run'
has 'Regression new</a>'
has 'new: 2 tasks, all run'
grep -qE '<td class="one">1[12][0-9] s</td>' build/report/index.html || fails "what it took"
mv regressions/new/report.txt regressions/new/.part
ends 0 scripts/report
has '3 failed, 1 passed, 2 not run'
has 'Regression old</a>'
mv regressions/new/.part regressions/new/report.txt

# The same with what is run again, and what fails then comes first.
script good "Good <one>" 'exit 1'
ends 1 scripts/good
ends 0 scripts/report
has '3 failed, 1 passed, 2 not run'
has_not 'two words'
ends 2 scripts/report --no
echo "as expected"
