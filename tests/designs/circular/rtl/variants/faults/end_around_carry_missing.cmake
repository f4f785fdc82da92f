variant("Accumulator 1 drops the carry out of its sign" W=4)
replace(circular_accumulator.v [[wire passes = take | low_more[L];]] [[wire passes = gives;]])
replace(circular_accumulator.v
  [[wire around = gives ? take | high_more[H] : high[H] ^ passes;]]
  [[wire around = take;]])
