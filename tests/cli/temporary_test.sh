#!/usr/bin/env bash
# temporary_test.sh PROGRAM
#
# Commands that run other programs, with a TMPDIR whose name tools cannot take, and with one that is
# full: they end with their verdict, or with 2 and one line that names the folder.
# Status: 0 so, 1 not, 77 without yosys, or where no file system may be mounted.
# Needs: linear
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
program=$(realpath "$1")
needs yosys
cd "$folder"
cp "$root/examples/counter/counter.v" .

# each CHECK: of each command with its words; lanes are made anew in a folder of their own.
each() {
  "$1" prove linear M=5 N=2
  "$1" sweep linear --m 5 --n 2 --hostile 100000 --lanes 64
  "$1" lint linear M=5 N=2
  rm -rf made
  "$1" new made counter.v
}

matches() {
  TMPDIR=$tmp "$program" "$@" > said 2>&1 || fails "$* ends with 0 where TMPDIR is '$tmp'"
}
if [[ ${INSIDE-} != yes ]]; then
  for tmp in "$folder/with a space" "$folder/it's \"\$(touch pwned)\"; touch pwned #"; do
    mkdir "$tmp"
    each matches
    [[ ! -e pwned && ! $(ls -A "$tmp") ]] || fails "nothing is run of the name, or left there"
  done
  unshare --mount true 2> said ||
    { echo "skipped: not here: a full TMPDIR, for no file system can be mounted" && exit 77; }
  # In a name space of its own, so that nothing stays mounted.
  INSIDE=yes unshare --mount "$root/tests/cli/temporary_test.sh" "$program"
  exit
fi

# refused: what does not fit is said, and nothing is blamed on the RTL.
refused() {
  local status=0
  TMPDIR=$tmp "$program" "$@" > out 2> said || status=$?
  ((status != 0 || size > 16)) || fails "$* needs more than $size kB"
  ((status == 0)) || [[ $status == 2 && $(< said) == "cosim: $tmp: no room for temporary files: "* &&
    $(wc -l < said) == 1 ]] || fails "$* names the folder in one line, of $size kB; it is $status"
  [[ ! $(ls -A "$tmp") ]] || fails "$* leaves nothing in the folder"
}
tmp=$folder/small
mkdir "$tmp"
trap 'umount "$tmp" 2> "$folder/said" || true; rm -rf "$folder"' EXIT
for size in 16 68 100 200; do
  mount -t tmpfs -o "size=${size}k" small "$tmp"
  each refused
  umount "$tmp"
done
echo "a verdict, or the folder's name"
