#!/usr/bin/env bash
# errors_test.sh COMPILER ROOT: likely mistakes in a model. The first error of the compiler or of the exporter
# must say in words what to do.
set -euo pipefail
compiler=$1 root=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
symbolic=("$compiler" -std=c++20 -g1 -DCOSIM_SYMBOLIC -I "$root")
printf '%s\n' '#include <cmath>' '#include "model/clocked/export.h"' 'using namespace cosim::clocked;' > "$scratch/head.h"
"${symbolic[@]}" -x c++-header "$scratch/head.h" -o "$scratch/head.h.gch" # compiled once for all

# mistake WORDS MEMBERS BODY [CLOCK]: of a model with these members and this body of clock().
mistake() {
  cat > "$scratch/model.cpp" << END
struct M {
  struct In { UInt<8> a, b; Bit n, p; };
  struct Out { UInt<8> x; };
  $2
  ${4-Out clock(const In& in)} { $3 }
};
std::string text() { return resting<M>(true), exported<M>("m").text; }
END
  if "${symbolic[@]}" -fsyntax-only -include "$scratch/head.h" "$scratch/model.cpp" 2> "$scratch/log"; then
    [[ $1 == fine ]] || { echo "no error: $2 $3" && exit 1; }
  elif ! grep -m 1 error: "$scratch/log" | grep -qF -- "$1"; then
    echo "not '$1': $2 $3" && grep -m 3 error: "$scratch/log" && exit 1
  fi
}

mistake fine 'UInt<8> r = 0;' 'r = in.a; return {.x = r};'
mistake fine 'static constexpr auto reset = both(active_low<&In::n>, active_high<&In::p>);' 'return {.x = in.p};'
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
mistake 'write UInt<8> in place of int' 'float r = 0;' 'return {.x = 0};'
mistake 'in place of std::array or std::vector' 'std::vector<UInt<8>> r;' 'return {.x = 0};'
mistake 'in place of std::array or std::vector' 'std::array<UInt<8>, 4> r{0, 0, 0, 0};' 'return {.x = r[0]};'
mistake 'write Array<UInt<8>, 4> r in place of UInt<8> r[4]' 'UInt<8> r[4] = {0, 0, 0, 0};' 'return {.x = r[0]};'
mistake 'no constructor' 'UInt<8> r; M() : r(0) {}' 'return {.x = r};'
mistake 'a model computes with integers' '' 'return {.x = in.a * 0.5};'
mistake 'a symbol is no number of C++' '' 'return {.x = int(std::sqrt(double(in.a)))};'
mistake 'clock() that changes registers is not const' 'UInt<8> r = 0;' 'r = in.a; return {.x = r};' \
  'Out clock(const In& in) const'
mistake 'In is const' '' 'in.a = 0; return {.x = in.a};'
mistake 'is not const' 'UInt<8> r = 0; void f() const { ++r; }' 'f(); return {.x = r};'
mistake 'a model has a function Out clock(const In& in)' 'UInt<8> r = 0;' 'r = in.a;' 'void clock(const In& in)'
mistake 'a model has a function Out clock(const In& in)' '' 'return {.x = 0};' 'Out clk(const In& in)'
mistake 'of pins that are a Bit' 'static constexpr bool reset = true;' 'return {.x = 0};'
mistake 'of pins that are a Bit' 'static constexpr auto reset = active_high<&In::a>;' 'return {.x = 0};'

# What compiles, and stops the exporter: a line a model.
cat > "$scratch/models.cpp" << 'END'
#include "model/clocked/export.h"
using namespace cosim::clocked;
#define MODEL(NAME, ...)                     \
  struct NAME {                              \
    struct In { UInt<8> a; };                \
    struct Out { UInt<8> x; };               \
    Array<UInt<8>, 4> r = 0;                 \
    UInt<8> deep(const UInt<8>& x) const {   \
      if (x == 0) return 0;                  \
      return deep(x + 1) + 1;                \
    }                                        \
    Out clock(const In& in) { __VA_ARGS__ }  \
  };
MODEL(Loop, UInt<8> x = in.a; while (x != 3) x += 2; return {.x = x};)
MODEL(Endless, UInt<8> x = in.a; while (true) x += 3;)
MODEL(Recursion, return {.x = deep(in.a)};)
MODEL(Shift, return {.x = in.a >> -1};)
MODEL(Index, return {.x = r[4]};)
MODEL(Static, static int clocks = 0; return {.x = ++clocks};)
MODEL(Sum, static UInt<8> sum = 0; sum += in.a; return {.x = sum};)
template <class Model>
void write(const std::string& folder, const char* name) {
  ways.most_seconds = 0.2;
  write_exported<Model>(folder + '/' + name, name);
}
int main(int, char** words) {
  write<Loop>(words[1], "Loop");
  write<Endless>(words[1], "Endless");
  write<Recursion>(words[1], "Recursion");
  write<Shift>(words[1], "Shift");
  write<Index>(words[1], "Index");
  write<Static>(words[1], "Static");
  write<Sum>(words[1], "Sum");
}
END
"${symbolic[@]}" "$scratch/models.cpp" -o "$scratch/export"
"$scratch/export" "$scratch"
while IFS=: read -r model words; do
  grep -qF -- "$words" "$scratch/$model.btor2" || { cat "$scratch/$model.btor2" && echo "not '$words'" && exit 1; }
  cmp "$scratch/$model.btor2" "$scratch/$model.ways.btor2"
done << END
Loop:models.cpp:14 forks most
Loop:the loop or recursion that it ends may not end
Endless:Endless: 0 ways through clock() and more: a loop may not end
Recursion:models.cpp:16 forks most
Recursion:the loop or recursion that it ends may not end
Shift:the model throws: a shift or an index is below 0
Index:the model throws: an Array of 4 elements has no element 4
Static:on no static or global variable
Sum:on no static or global variable
END

# What does not end, asking no condition of a symbol, in the build of a design.
cd "$scratch"
printf '%s\n' '#include "model/clocked/export.h"' 'using namespace cosim::clocked;' \
  '#include "never.h"' 'int main() { write_exported<M>("never", "never"); }' > never.cpp
# never WORDS BODY: with this body of clock(), the file has one line, which names the header.
never() {
  cat > never.h << END
struct M {
  struct In { UInt<8> a; };
  struct Out { UInt<8> x; };
  int deep(volatile int& x) { return x + deep(x) + x; }
  Out clock(const In& in) { volatile int x = 0; $2 return {.x = in.a}; }
};
END
  cmake "-DCOMPILER=$compiler" -DSOURCE=never.cpp "-DSTAMP=$scratch/never.stamp" "-DINCLUDES=$root" -DMODEL=never.h \
    -DFILES=never -DSECONDS=1 -P "$root/tb/package/design_export.cmake"
  [[ $(< never.btor2) == "; error: never.h: $1: a loop or recursion in it may not end" ]] || { cat never.btor2 && exit 1; }
  cmp never.btor2 never.ways.btor2
}
never 'the model is not exported within 1 s' 'while (x == 0) {}'
never 'the exporter of the model stops with "Segmentation fault"' 'x = deep(x);'
