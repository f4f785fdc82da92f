#!/usr/bin/env bash
# scripts/fresh sees what a command changes of the system, and leaves nothing behind, interrupted or
# not. On a machine of a few programs, made by a debootstrap of its own.
# Status: 0 so, 1 not, 77 where that cannot be tried.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
unshare --mount --pid --fork true 2> /dev/null ||
  { echo "skipped: not here: no right to make a machine in a folder" && exit 77; }
git -C "$root" rev-parse HEAD > /dev/null 2>&1 ||
  { echo "skipped: not here: the project is no clone" && exit 77; }
mkdir "$folder/bin" "$folder/tmp"
cat > "$folder/bin/debootstrap" << 'DEBOOTSTRAP'
#!/usr/bin/env bash
# debootstrap --variant=minbase SUITE MACHINE ARCHIVE
set -euo pipefail
[[ $2 == trixie && $4 == file:/archive ]]
mkdir -p "$3"/{dev,etc,proc,root,sys,tmp,usr/bin}
ln -s usr/bin "$3/bin"
for program in bash env touch chmod sleep ls; do
  file=$(command -v "$program")
  cp "$file" "$3/usr/bin"
  ldd "$file" | grep -o '/[^ )]*' | while read -r library; do
    mkdir -p "$3$(dirname "$library")" && cp -u "$library" "$3$library"
  done
done
DEBOOTSTRAP
chmod +x "$folder/bin/debootstrap"
export PATH=$folder/bin:$PATH TMPDIR=$folder/tmp
mode=$(stat -c %a /dev/null)

fail() {
  printf '%s\n%s\n' "$1" "$output"
  exit 1
}

clean() {
  [[ ! $(ls -A "$folder/tmp") ]] || fail "left behind: $(ls "$folder/tmp")"
  ! grep -q "$folder" /proc/mounts || fail "left mounted"
  [[ $(stat -c %a /dev/null) == "$mode" ]] || fail "/dev/null of this machine has changed"
}

# expect STATUS PATTERN COMMAND...
expect() {
  local status=0
  output=$("$root/scripts/fresh" trixie --archive file:/archive "${@:3}" 2>&1) || status=$?
  ((status == $1)) || fail "${*:3}: status $status for $1"
  grep -qE -- "$2" <<< "$output" || fail "${*:3}: does not say $2"
  clean
}

expect 0 '^the system is as it was' "touch README.md /tmp/new"
expect 0 '^ +[0-9.]+ s  touch /etc/before$' "touch /etc/before" true
expect 1 '^ > \./etc/new	f 644 0:0 0 $' "touch /etc/new"
expect 1 '^ > [0-9a-f]{64}  \./etc/hosts$' "echo more >> /etc/hosts"
expect 1 '^ < dev/null	c 666' "chmod 755 /dev/null"
expect 1 '^status 3: exit 3$' "exit 3"
expect 0 'as it was' "[[ ! -e /proc/$$ ]]"
[[ $("$root/scripts/fresh" Debian 2>&1) == "fresh: needs a suite of Debian, such as bookworm or trixie" ]]

echo brought > "$folder/it"
expect 0 'as it was' --bring "$folder/it" "[[ -s /tmp/it ]]"
expect 2 "^fresh: --bring: $folder/none: no such file$" --bring "$folder/none" true

expect 0 'as it was' --keep "$folder/kept" true
[[ -x $folder/kept/root/project/scripts/test ]] || fail "--keep: not kept"

# A signal, while something runs inside.
"$root/scripts/fresh" trixie --archive file:/archive "sleep 12345" > "$folder/said" 2>&1 &
fresh=$!
until grep -q "^== sleep" "$folder/said"; do sleep 0.1; done
sleep 0.3
kill -TERM "$fresh"
status=0
wait "$fresh" || status=$?
output=$(< "$folder/said")
((status == 143)) || fail "a signal: status $status"
! pgrep -f "sleep 12345" > /dev/null || fail "a signal: something still runs"
clean
echo "as expected"
