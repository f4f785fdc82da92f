#!/usr/bin/env bash
# readme_test.sh PROGRAM: the table of claims in README.md is what the program measures.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
diff <(sed -n '/^| claim /,/^$/{/^|/p}' "$root/README.md") <("$1")
