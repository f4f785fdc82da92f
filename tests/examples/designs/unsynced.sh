# shellcheck shell=bash disable=SC2154
ends 1 replay "${smallest[0]}"
says "one_of_two"
awk '/^[0-9]/ { $(NF - 1) = $NF = 0 } { print }' "${smallest[0]}" > old.stim
ends 0 replay old.stim
# Of two resets at once, one a clock, `new` says what each resets.
ends 0 new made "$designs/unsynced.sv"
grep -q 'CLOCKS a_clk b_clk' made/CMakeLists.txt || fails "the clocks are found"
grep -q 'reset = both(active_high<&In::b_rst>, active_low<&In::a_rst_n>);' made/made.h || fails "so are the resets"
