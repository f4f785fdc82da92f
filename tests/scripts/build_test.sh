#!/usr/bin/env bash
# CMake runs again when a tool was installed or removed, and from the start with another compiler, but
# not otherwise. Tested with a CMake that only prints its arguments.
# Status: 0 so, 1 not.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
mkdir "$folder/scripts" "$folder/bin"
cp "$root/scripts/lib.sh" "$folder/scripts"
for tool in bash basename dirname mkdir flock grep mktemp cat rm nproc tee; do
  ln -s "$(command -v "$tool")" "$folder/bin/$tool"
done
cat > "$folder/bin/cmake" << 'CMAKE'
#!/usr/bin/env bash
echo "$* ${COSIM_WERROR-}" >> "$ASKED"
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
echo "as expected"
