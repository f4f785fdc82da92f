#!/usr/bin/env bash
# The harness names no design: no line of its files has the name of one in rtl/shipped.txt where it names
# a design: as a scope, a folder, a file, a class of Verilator, a text in quotes, beside a parameter or
# as the argument of a command. In prose the word may be a word: "a linear search". A test of the harness
# that names one says so. First on a small tree with such lines, then on the project.
# Status: 0 so it is, 1 not, with FILE:LINE:TEXT of each find.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
# pattern NAMES: an expression of lines that name one of NAMES, a|b|c.
pattern() {
  local begins='(^|[^[:alnum:]_])' ends='([^[:alnum:]_]|$)'
  local commands='list|sweep|replay|prove|mutate|lint|cover|without|designs'
  printf '%s|' "$begins($1)(::|/|_[a-z]|\.(v|h|cpp|cmake|txt)|[\"'>]| [A-Z]+=)" \
    "[/\"'<]($1)$ends" "${begins}V($1)"
  printf '%s' "$begins($commands) ($1)$ends"
}

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
    xargs grep -nHE "$(pattern "$names")" || true
}

# unsaid TREE: tests of the harness that name a design which their line "Needs: NAME, NAME" has not.
unsaid() {
  cd "$1"
  local names name file
  names=$(sed -E '/^(#|$)/d; s/ .*//' rtl/shipped.txt | sort -u)
  for name in $names; do
    find tests -type f \( -name '*_test.cpp' -o -path '*/fuzz/targets/*.cpp' -o -name '*_test.sh' \) |
      grep -vE '^tests/(designs|studies|model|scripts|examples)/' | LC_ALL=C sort |
      { xargs grep -lE "$(pattern "$name")" || true; } | while read -r file; do
      grep -qE "^(//|#) Needs: (.*, )?$name(,|$)" "$file" || echo "$file: does not say: Needs: $name"
    done
  done
}

tree=$folder/tree
mkdir -p "$tree"/{rtl,scripts,model/{core,first},tb/{cli,designs/first,studies/both},tests/{cli,designs}}
cd "$tree"
printf '# A comment.\nfirst W=4\nsecond W=4\nfirst W=8\n' > rtl/shipped.txt
printf 'one\nVfirst_ of the RTL\n' > tb/cli/x.cpp
echo 'seconds, firstly, theFirst, vsecondary; the first of all, by second' > tb/cli/allowed.cpp
echo 'cosim sweep second' | tee scripts/run tests/cli/x_test.cpp > tests/CMakeLists.txt
echo '#include "model/first/x.h"' | tee model/first/x.h tb/designs/first/x.h tb/studies/both/x.h \
  tests/designs/CMakeLists.txt > model/core/x.h
printf '%s\n' 'using first::Design;' '"second W=4"' 'prove(second);' > tb/cli/y.cpp
diff - <(finds "$tree") <<- 'END'
	model/core/x.h:1:#include "model/first/x.h"
	scripts/run:1:cosim sweep second
	tb/cli/x.cpp:2:Vfirst_ of the RTL
	tb/cli/y.cpp:1:using first::Design;
	tb/cli/y.cpp:2:"second W=4"
	tests/CMakeLists.txt:1:cosim sweep second
END

# A line for another design is none for this one.
printf '// Needs: first\nfirst::Design; "second"\n' > tests/cli/y_test.cpp
diff - <(unsaid "$tree") <<- 'END'
	tests/cli/x_test.cpp: does not say: Needs: second
	tests/cli/y_test.cpp: does not say: Needs: second
END

found=$(finds "$root" && unsaid "$root")
[[ -z $found ]] || { echo "$found" && exit 1; }
echo "as expected"
