variant("Channel 3 has CT7 as it was before the step" W=16)

replace(circular_commutator.v [[
  wire         moved = (channel3 & ct7_q[0]) | (channel2 & ~ct7_q[0]);
]] [[
  wire         moved = channel2 & ~ct7_q[0];
]])

replace(circular_commutator.v [[
  wire lowest = channel1 ? ct8_odd : ct7_q[0] ^ channel2;
]] [[
  wire lowest = channel1 ? ct8_odd : ct7_q[0] ^ (channel2 | channel3);
]])
