# shellcheck shell=bash
# The head of a test: `root` is the checkout, and the folder `folder` goes with the test.
set -euo pipefail
# shellcheck disable=SC2034 # for the test
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
readonly folder
unset GITHUB_ACTIONS # else a failure is printed for its log, too
trap 'rm -rf "$folder"' EXIT

# fails TEXT...: what was not so, and what was said last.
fails() {
  [[ ! -f said ]] || cat said
  printf 'not so: %s\n' "$*"
  exit 1
}
# needs TOOL...: where one is missing the test is skipped.
needs() {
  local tool
  for tool; do
    command -v "$tool" > /dev/null || { echo "skipped: no $tool" && exit 77; }
  done
}
