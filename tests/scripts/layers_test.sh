#!/usr/bin/env bash
# The harness names no design: no line of its files holds the name of one in rtl/shipped.txt as a word,
# or the word for what the shipped ones are. First on a small tree with such lines, then on the project.
# Status: 0 so it is, 1 not, with FILE:LINE:TEXT of each find.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# finds TREE: the lines that name a design. Tests of the harness run on some design, so of tests/ only
# the build and what serves every design are searched.
finds() {
  cd "$1"
  local names folders=() path
  names=$(sed -E '/^(#|$)/d; s/ .*//' rtl/shipped.txt | sort -u | paste -sd '|')
  [[ $names ]] || { echo "rtl/shipped.txt: no design" && return; }
  for path in tb scripts model/core .github .ci CMakeLists.txt CMakePresets.json \
    tests/{benchmark,careless,mutation,support}; do
    [[ ! -e $path ]] || folders+=("$path")
  done
  {
    find "${folders[@]}" -type f -print
    find tests -type f \( -name CMakeLists.txt -o -name '*.cmake' -o -name '*.in' \) -print
  } | grep -vE '^(tb|tests)/(designs|studies)/' | LC_ALL=C sort -u |
    xargs grep -nHiE "(^|[^[:alpha:]]|\bV)($names)([^[:alpha:]]|\$)|interpolat" || true
}

tree=$folder/tree
mkdir -p "$tree"/{rtl,scripts,model/{core,first},tb/{cli,designs/first,studies/both},tests/{cli,designs}}
cd "$tree"
printf '# A comment.\nfirst W=4\nsecond W=4\nfirst W=8\n' > rtl/shipped.txt
printf 'one\nVfirst_ of the RTL\n' > tb/cli/x.cpp
echo 'seconds, firstly, theFirst, vsecondary' > tb/cli/allowed.cpp
echo '# by SECOND' | tee scripts/run tests/cli/x_test.cpp > tests/CMakeLists.txt
echo '#include "model/first/x.h"' | tee model/first/x.h tb/designs/first/x.h tb/studies/both/x.h \
  tests/designs/CMakeLists.txt > model/core/x.h
echo '// An interpolator.' > tb/cli/y.cpp
diff - <(finds "$tree") <<- 'END'
	model/core/x.h:1:#include "model/first/x.h"
	scripts/run:1:# by SECOND
	tb/cli/x.cpp:2:Vfirst_ of the RTL
	tb/cli/y.cpp:1:// An interpolator.
	tests/CMakeLists.txt:1:# by SECOND
END

found=$(finds "$root")
[[ -z $found ]] || { echo "$found" && exit 1; }
echo "as expected"
