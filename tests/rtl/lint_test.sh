#!/usr/bin/env bash
# scripts/lint finds faults: each is planted in a copy of the RTL, or in a small tree of C++ and
# scripts, and the tools that are to see it must say what it is.
# Status: 0 all seen, 1 not, 77 where a tool is not installed.
# Needs: circular
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
needs verilator iverilog yosys clang-tidy cppcheck shellcheck clang++ cmake ninja
copy=$folder/rtl
mkdir "$copy"
cp -r "$root/rtl/circular" "$copy"
echo 'circular W=8' > "$copy/shipped.txt"
top=$copy/circular/circular.v
original=$(< "$top")
failures=0

# lint [OPTION FOLDER]: the RTL of the copy, or what the option says; `output` and `status` are what
# came of it.
lint() {
  status=0
  output=$("$root/scripts/lint" --junit "$folder/junit.xml" "${1---rtl}" "${2-$copy}" 2>&1) || status=$?
}

# expect TITLE STATUS [PATTERN...]: the last lint ended so, and its output has each pattern.
expect() {
  local title=$1 expected=$2 pattern missed=()
  ((status == expected)) || missed+=("status $expected, but $status")
  for pattern in "${@:3}"; do
    grep -qE -- "$pattern" <<< "$output" || missed+=("$pattern")
  done
  if ((!${#missed[@]})); then
    echo "seen: $title"
    return
  fi
  echo "NOT SEEN: $title"
  printf '  missed: %s\n' "${missed[@]}"
  printf '%s\n' "$output"
  failures=$((failures + 1))
}

# fault TITLE VERILOG PATTERN...: planted at the end of the top module.
fault() {
  printf '%s\n' "${original/$'\nendmodule'/$'\n'"$2"$'\nendmodule'}" > "$top"
  lint
  expect "$1" 1 "${@:3}"
  printf '%s\n' "$original" > "$top"
}

lint
expect "no fault" 0 '^verilator .* 1  clean$' '^iverilog .* 1  clean$' '^yosys .* 1  clean$' \
  '^waivers .* clean$'
# in_junit PATTERN: a line of what --junit wrote.
in_junit() { grep -qE -- "$1" "$folder/junit.xml" || { cat "$folder/junit.xml" && failures=$((failures + 1)); }; }
in_junit '<testsuite name="scripts/lint" tests="4" failures="0" errors="0">'

fault "latch" 'reg planted; always @* if (clk) planted = rst;' \
  'Warning-LATCH' '^yosys .* findings' 'proc_dlatch'
in_junit '<testsuite name="scripts/lint" tests="4" failures="[23]" errors="0">'
in_junit '<testcase classname="lint" name="yosys, check -assert, no latch">$'
in_junit '<failure message="findings in 1">'
fault "truncation" 'wire [3:0] planted = {5{clk}};' \
  'Warning-WIDTH' "5 bits"
fault "truncation at a port" \
  'circular_accumulator #(.W(W)) planted
     (.clk(clk), .clear(rst), .take(load), .add(rst), .f({f, rst}), .addend(f),
      .f_q(), .negative());' \
  'Warning-WIDTH' '^iverilog .* findings' 'warning: Port [0-9]+ .f. of circular_accumulator expects 10 bits' \
  '^yosys .* findings' 'Warning: Resizing cell port'
fault "unused signal" 'wire planted = clk;' \
  'Warning-UNUSED.*planted'
fault "undriven net" \
  'wire planted;
   circular_accumulator #(.W(W)) reader
     (.clk(clk), .clear(planted), .take(load), .add(rst), .f(f), .addend(f), .f_q(),
      .negative());' \
  'Warning-UNDRIVEN.*planted' '^yosys .* findings' 'planted is used but has no driver'
fault "input left open" \
  'circular_accumulator #(.W(W)) planted
     (.clk(clk), .take(load), .add(rst), .f(f), .addend(f), .f_q(),
      .negative());' \
  'Warning-PINMISSING' '^iverilog .* findings' 'dangling input port.*clear'
fault "two drivers" 'assign running = rst;' \
  '^yosys .* findings' 'multiple conflicting drivers'
fault "waiver" \
  '/* verilator lint_off UNUSED */ wire planted = clk; /* verilator lint_on UNUSED */' \
  '^verilator .* clean$' '^waivers .* findings in 1$' 'circular\.v:[0-9]+:.*lint_off'

mkdir "$copy/spare" && touch "$copy/spare/spare.v"
lint
expect "design that is not shipped" 1 '^waivers .* findings in 1$' 'spare\.v: no line'
rm -r "$copy/spare"

: > "$copy/shipped.txt"
lint
expect "nothing shipped" 1 '^verilator .* nothing to lint$'

# ---- C++ and scripts --------------------------------------------------------------------------

tree=$copy/tree
mkdir -p "$tree"/{rtl,model,tb,tests,scripts,.ci}
cp -r "$root/rtl/circular" "$tree/rtl"
echo 'circular W=8' > "$tree/rtl/shipped.txt"
cp "$root/.clang-format" "$root/.clang-tidy" "$tree"
good='int third(const int* list) { return list == nullptr ? 0 : list[2]; }'
printf '%s\n' "$good" | tee "$tree/model/good.cpp" > "$tree/tb/good.cpp"
printf '%s\n' '#!/usr/bin/env bash' 'true' > "$tree/scripts/good"

# planted TITLE FILE TEXT PATTERN...: beside the good ones.
planted() {
  printf '%s\n' "$3" > "$tree/$2"
  lint --tree "$tree"
  expect "$1" 1 "${@:4}"
  rm "$tree/$2"
}

lint --tree "$tree"
expect "no fault in the tree" 0 '^clang-format +(.* 2  clean$|not checked: )' '^cppcheck .* 2  clean$' \
  '^clang-tidy .* 1  clean$' '^shellcheck .* 1  clean$' '^devices .* 1  clean$'
! command -v clang-format-14 > /dev/null || planted "text out of format" tests/planted.h 'int  third ( int );' \
  '^clang-format .* findings in 1$' 'tests/planted.h.*clang-format-violations'
planted "index out of bounds" tb/planted.cpp \
  'int third() {
  int list[2] = {1, 2};
  return list[2];
}' '^cppcheck .* findings in 1$' 'tb/planted.cpp:3.*arrayIndexOutOfBounds'
planted "division of integers as a real number" model/planted.cpp \
  'double half(int n) { return n / 2; }' \
  '^clang-tidy .* findings in 1$' 'model/planted.cpp:1.*bugprone-integer-division'
null=/dev/null
planted "a device as a tool's output" scripts/planted "#!/usr/bin/env bash
iverilog -o $null a.v" '^devices .* findings in 1$' 'scripts/planted:2:iverilog'
planted "a device as a command's output" tests/planted.cmake "execute_process(COMMAND tool --output=$null)" \
  '^devices .* findings in 1$' 'planted.cmake:1:'
planted "unused variable" scripts/planted '#!/usr/bin/env bash
planted=1' '^shellcheck .* findings in 1$' 'SC2034'

# ---- C++ as Clang compiles it -------------------------------------------------------------------

project=$copy/project
mkdir -p "$project"
cat > "$project/CMakeLists.txt" << 'END'
cmake_minimum_required(VERSION 3.25)
project(planted LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 20)
add_compile_options(-Wall)
file(WRITE ${CMAKE_BINARY_DIR}/made.cpp "what nobody wrote\n")
add_library(one good.cpp planted.cpp ${CMAKE_BINARY_DIR}/made.cpp)
set_source_files_properties(${CMAKE_BINARY_DIR}/made.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
add_library(two planted.cpp)
END
printf '%s\n' "$good" > "$project/good.cpp"
# with_clang TITLE STATUS TEXT PATTERN...: the project with that text in planted.cpp, file by file and as
# unity files; each file is compiled once, and none that was generated.
with_clang() {
  local unity
  printf '%s\n' "$3" > "$project/planted.cpp"
  for unity in ON OFF; do
    cmake -S "$project" -B "$project/build" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_UNITY_BUILD=$unity \
      -DCMAKE_EXPORT_COMPILE_COMMANDS=ON > "$folder/cmake"
    lint --clang "$project/build"
    expect "$1, unity files $unity" "$2" "${@:4}"
  done
}
with_clang "no fault for Clang" 0 'int two = 2;' '^clang +2 files, .* clean$'
# What GCC compiles.
with_clang "views over a container" 1 '#include <ranges>
#include <vector>
int sum(const std::vector<int>& all) {
  int sum = 0;
  for (const int one : all | std::views::drop(1)) sum += one;
  return sum;
}' '^clang .* findings in 1$' '^planted.cpp:5:.*error'
with_clang "a container's part" 1 '#include <algorithm>
#include <vector>
auto both(const std::vector<int>& all) {
  return std::ranges::equal_range(all, 1).begin();
}' '^clang .* findings in 1$' '^planted.cpp:4:.*note: in instantiation'
with_clang "a warning of Clang alone" 1 'struct One {
  const int n;
  One() = default;
};' '^clang .* findings in 1$' '^planted.cpp:3:.*warning'

exit $((failures > 0))
