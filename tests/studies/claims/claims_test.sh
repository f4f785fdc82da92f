#!/usr/bin/env bash
# claims_test.sh PROGRAM: the known figures of the claims are reached, and the tables of them and of the
# largest errors of lines in docs/interpolators/comparison.md are what the program measures.
source "$(dirname "${BASH_SOURCE[0]}")/../../support/head.sh"
measured=$folder/measured
status=0
"$1" > "$measured" || status=$?
diff <(sed -n '/^| claim /,/^$/p; /^| lines of /,/^$/{/^|/p}' "$root/docs/interpolators/comparison.md") \
  "$measured" || status=1
exit "$status"
