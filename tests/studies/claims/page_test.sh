#!/usr/bin/env bash
# page_test.sh PROGRAM: the tables in docs/comparison.md of the claims and of the largest errors of lines
# are what the program measures.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
diff <(sed -n '/^| claim /,/^$/p; /^| lines of /,/^$/{/^|/p}' "$root/docs/comparison.md") <("$1")
