#!/usr/bin/env bash
# CMake runs again when a tool was installed or removed, and from the start with another compiler, but
# not otherwise; and what fails is one line. Tested with a CMake that only prints its arguments.
# Status: 0 so, 1 not.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
mkdir "$folder/scripts" "$folder/bin"
cp "$root/scripts/lib.sh" "$folder/scripts"
for tool in bash basename dirname mkdir flock grep mktemp cat rm nproc tee sed; do
  ln -s "$(command -v "$tool")" "$folder/bin/$tool"
done
cat > "$folder/bin/cmake" << 'CMAKE'
#!/usr/bin/env bash
echo "$* ${COSIM_WERROR-}" >> "$ASKED"
[[ $* == --build* ]] && which=${FAILS_BUILD-} || which=${FAILS_CONFIGURE-}
[[ ! $which ]] || { cat "$which" && exit 1; }
[[ $* != --build* ]] || exit 0
cd "$(dirname "$ASKED")/build"
: > build.ninja
[[ ! $* =~ (BUILD_TESTING)=(ON|OFF) ]] || echo "${BASH_REMATCH[1]}:BOOL=${BASH_REMATCH[2]}" > CMakeCache.txt
CMAKE
chmod +x "$folder/bin/cmake"
export ASKED=$folder/asked
unset CXX COSIM_WERROR

# expect TITLE LINE [NAME=VALUE...]: a build of $target, with these in the environment, configures with
# LINE, or where that is empty not at all.
target=cosim
expect() {
  local asked
  : > "$ASKED"
  env PATH="$folder/bin" "${@:3}" bash -c "source '$folder/scripts/lib.sh'; build default $target"
  asked=$(grep -v '^--build' "$ASKED") || true
  grep -q "^--build --preset default --target $target" "$ASKED" || { echo "$1: no build" && exit 1; }
  [[ $asked == "$2" ]] || { printf '%s: "%s" for "%s"\n' "$1" "$asked" "$2" && exit 1; }
}

expect "the program alone" "--preset default -DBUILD_TESTING=OFF "
expect "it again" ""
target=all
expect "all" "--preset default -DBUILD_TESTING=ON "
expect "again" ""
target=cosim
expect "the program after that" ""
target=all
touch "$folder/bin/yosys" && chmod +x "$folder/bin/yosys"
expect "with yosys" "--preset default -DBUILD_TESTING=ON "
expect "with yosys, again" ""
expect "warnings as errors" "--preset default -DBUILD_TESTING=ON ON" COSIM_WERROR=ON
expect "as it was" ""
expect "another compiler" "--fresh --preset default -DBUILD_TESTING=ON ON" CXX=clang++
expect "that compiler" "" CXX=clang++
expect "as it is" ""
rm "$folder/bin/yosys"
expect "without yosys" "--preset default -DBUILD_TESTING=ON ON"
rm "$folder/build/build.ninja" "$folder/build/CMakeCache.txt"
expect "without what CMake made" "--preset default -DBUILD_TESTING=ON "

# fails_with LINE NAME=FILE: a build in which CMake prints FILE and fails ends with 2 and that line alone,
# and FILE is its log.
fails_with() {
  local status=0 said
  said=$(env PATH="$folder/bin" "$2" bash -c "source '$folder/scripts/lib.sh'; ready default cosim" \
    caller 2>&1) || status=$?
  [[ $status == 2 && $said == "caller: cosim is not built: $1; its log: $folder/build/build.log" ]] ||
    { printf 'status %s: %s\n' "$status" "$said" && exit 1; }
  cmp "${2#*=}" "$folder/build/build.log"
}
# What ninja, GCC in colours and Clang print, with hundreds of lines of notes.
notes() { for ((i = 0; i < 300; ++i)); do echo "/usr/include/c++/12/ranges:$i:9: note: error: so it is"; done; }
echo 'exit 0' > "$folder/scripts/setup" && chmod +x "$folder/scripts/setup"
{
  printf '[1/9] one\nFAILED: tb/CMakeFiles/one.o\n/usr/bin/g++ -c unity_0.cxx\nIn file included from unity_0.cxx:3:\n'
  printf '\e[01m\e[K%s/build/../tb/one.cpp:7:9:\e[m\e[K \e[01;31m\e[Kerror: \e[m\e[Kno name\n' "$folder"
  notes
  printf 'ninja: build stopped: subcommand failed.\n'
} > "$folder/gcc"
fails_with "tb/one.cpp:7:9: error: no name" FAILS_BUILD="$folder/gcc"
{
  printf 'FAILED: tb/two.o\n%s/tb/two.h:70:1: warning: so so\n' "$folder"
  notes
  printf "%s/tb/two.cpp:1:10: fatal error: 'x.h' file not found\n" "$folder"
} > "$folder/clang"
fails_with "tb/two.cpp:1:10: fatal error: 'x.h' file not found" FAILS_BUILD="$folder/clang"
printf 'FAILED: cosim\n: && g++ -o cosim\nld: a.o: in function main:\na.cpp:(.text+0x5): undefined reference to f()\n' \
  > "$folder/linker"
fails_with "a.cpp:(.text+0x5): undefined reference to f()" FAILS_BUILD="$folder/linker"
printf '[3/4] x\nFAILED: tb/page.h \ncd tb && false\n' > "$folder/command"
fails_with "FAILED: tb/page.h" FAILS_BUILD="$folder/command"
rm "$folder/build/build.ninja"
printf -- '-- Found ZLIB\nCMake Error at CMakeLists.txt:36 (find_package):\n  By not providing "Findfmt.cmake" in\n  CMAKE_MODULE_PATH\n' \
  > "$folder/cmake"
fails_with 'CMake Error at CMakeLists.txt:36 (find_package): By not providing "Findfmt.cmake" in CMAKE_MODULE_PATH' \
  FAILS_CONFIGURE="$folder/cmake"
echo "as expected"
