# shellcheck shell=bash
# A word of a memory has its index in the mismatch, in the wave and in a stimulus; a wide number is
# one trace of the wave.
smallest=(failures/wires-FAULT1-*/smallest.stim)
ends 1 replay "${smallest[0]}" --wave wires.fst --html wires.html
for trace in 'order[3] expected' 'order[3] actual' 'held'; do
  grep -qE -- ">${trace//[\[\]]/.}[ <]" wires.html || fails "the page of wires has $trace"
done
says 'order[3]'
says 'd[99:64]'
for trace in 'First difference: order[3]' 'cosim.actual.order[3][4:0]' 'cosim.actual.held[99:0]' \
  'cosim.inputs.d[99:0]' 'cosim.actual.lines[7][63:0]'; do
  grep -qF -- "$trace" wires.gtkw || fails "the wave of wires has $trace"
done
! grep -qF 'order[5]' wires.gtkw || fails 'the wave of wires has words that the RTL has not'
sed 's/^power-up.*/&\nstate order[3]=9 lines[5]=-1 held[99:64]=77/' "${smallest[0]}" > from_state.stim
ends 1 replay from_state.stim
sed 's/FAULT=1/FAULT=0/' from_state.stim > good.stim
ends 0 replay good.stim
sed 's/^power-up.*/&\nstate order[5]=9/' "${smallest[0]}" > no_word.stim
ends 2 replay no_word.stim
says "has no state 'order[5]'"
