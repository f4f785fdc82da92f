# shellcheck shell=bash disable=SC2154
# RTL and model agree in the fault: that the RTL's assertion fails is all that is wrong, and it does so only
# where the synchronizer takes some bits of the new value. The stimulus without them shows nothing.
ends 1 replay "${smallest[0]}"
says "the RTL says: "
says "never_more"
for stimulus in failures/counted-FAULT1-*/{stimulus,smallest}.stim; do
  awk '/^clock / { for (i = 1; i <= NF; ++i) if ($i == "first_new") at = i }
    /^[0-9]/ { taken += gsub(/1/, 0, $at) } { print }
    END { if (!taken) exit 1 }' "$stimulus" > old.stim || fails "$stimulus has bits that take the new value"
  ends 0 replay old.stim
done
