variant("Variant -1 adds 2X + 1" W=16)
replace(circular_commutator.v [[
  wire last = (channel1 & ~t16_q & ~ct8_zero_or_one) | (channel2_down & ~ct7_zero);
]] [[
  wire last = (channel1 & ~t16_q & ~ct8_zero_or_one)
            | (~channel1 & ~channel3 & ~(channel2_down & ct7_zero));
]])
