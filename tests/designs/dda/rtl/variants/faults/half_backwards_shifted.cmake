variant("A rate of minus half of the accumulator is shifted once more" W=6)
replace(dda_full.v
  [[assign full = (rate[W] ^ rate[W-1]) | (rate[W] & ~|rate[W-2:0]);]]
  [[assign full = rate[W] ^ rate[W-1];]])
