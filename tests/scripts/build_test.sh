#!/usr/bin/env bash
# What is installed later is found later: CMake runs again when a tool has come or gone, and begins
# anew with another compiler; else it does not. With a CMake that only says what it is asked.
# Status: 0 so, 1 not.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/scripts" "$folder/bin"
cp "$root/scripts/lib.sh" "$folder/scripts"
for tool in bash basename dirname mkdir flock mktemp cat rm nproc tee; do
  ln -s "$(command -v "$tool")" "$folder/bin/$tool"
done
cat > "$folder/bin/cmake" << 'CMAKE'
#!/usr/bin/env bash
echo "$* ${COSIM_WERROR-}" >> "$ASKED"
[[ $* == --build* ]] || : > "$(dirname "$ASKED")/build/build.ninja"
CMAKE
chmod +x "$folder/bin/cmake"
export ASKED=$folder/asked
unset CXX COSIM_WERROR

# expect TITLE LINE [NAME=VALUE...]: a build, with these in the environment, configures with LINE,
# or where that is empty not at all.
expect() {
  local asked
  : > "$ASKED"
  env PATH="$folder/bin" "${@:3}" bash -c "source '$folder/scripts/lib.sh'; build default all"
  asked=$(grep -v '^--build' "$ASKED") || true
  grep -q '^--build --preset default --target all' "$ASKED" || { echo "$1: no build" && exit 1; }
  [[ $asked == "$2" ]] || { printf '%s: "%s" for "%s"\n' "$1" "$asked" "$2" && exit 1; }
}

expect "the first time" "--preset default "
expect "again" ""
touch "$folder/bin/yosys" && chmod +x "$folder/bin/yosys"
expect "with yosys" "--preset default "
expect "with yosys, again" ""
expect "warnings as errors" "--preset default ON" COSIM_WERROR=ON
expect "as it was" ""
expect "another compiler" "--fresh --preset default ON" CXX=clang++
expect "that compiler" "" CXX=clang++
expect "as it is" ""
rm "$folder/bin/yosys"
expect "without yosys" "--preset default ON"
rm "$folder/build/build.ninja"
expect "without what CMake made" "--preset default "
echo "as expected"
