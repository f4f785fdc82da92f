#!/usr/bin/env bash
# errors_test.sh COMPILER ROOT: likely mistakes in a model; each must be an error that says so in words.
set -euo pipefail
compiler=$1 root=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# mistake WORDS MEMBERS BODY: of a model with these members and this body of clock().
mistake() {
  cat > "$scratch/model.cpp" << END
#include "model/clocked/export.h"
#include <string>
using namespace cosim::clocked;
struct M {
  struct In { UInt<8> a, b; };
  struct Out { UInt<8> x; };
  $2
  Out clock(const In& in) { $3 }
};
std::string text() { return exported<M>("m").text; }
END
  if "$compiler" -std=c++20 -fsyntax-only -DCOSIM_SYMBOLIC -I "$root" "$scratch/model.cpp" \
    2> "$scratch/log"; then
    [[ $1 == fine ]] || { echo "no error: $2 $3" && exit 1; }
  elif ! grep -qF -- "$1" "$scratch/log"; then
    echo "not '$1': $2 $3" && grep -m 3 error: "$scratch/log" && exit 1
  fi
}

mistake fine 'UInt<8> r = 0;' 'r = in.a; return {.x = r};'
mistake 'this value has no initial value' 'UInt<8> r;' 'return {.x = r};'
mistake 'this value has no initial value' '' 'UInt<8> y; if (in.a) y = 1; return {.x = y};'
mistake 'this value has no initial value' '' 'Out out; out.x = in.a; return out;'
mistake 'this Array has no initial value' 'Array<UInt<8>, 4> r;' 'return {.x = r[in.a]};'
mistake 'a symbol is no number of C++' '' 'return {.x = int(in.a) + 1};'
mistake 'write UInt<8> in place of int' 'int r = 0;' '++r; return {.x = r};'
mistake 'a model, its In and its Out are plain structs' 'virtual ~M() = default;' 'return {.x = 0};'
mistake 'is unsigned: make it a UInt' '' 'return {.x = in.a >> Int<3>(in.b)};'
mistake 'cat() takes values, whose widths are known' '' 'return {.x = cat(in.a, 1)};'
mistake 'a value has 1 to 4096 bits' 'UInt<5000> r = 0;' 'return {.x = 0};'
mistake 'is not within the value' '' 'return {.x = in.a.slice<8, 1>()};'
mistake 'takes a way for each number' '' 'return {.x = (in.a * in.b).value()};'
