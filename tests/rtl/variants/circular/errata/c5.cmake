variant("C5: channel 1 gives -0 for the diagonal step to X - Y = 0" W=4)

replace(circular_commutator.v [[
  wire [W+1:0] word1   = leaving ? {{W{1'b1}}, ~ct8_step[0], 1'b0} : {ct8_step, ~t16_q};
]] [[
  wire [W+1:0] word1   = leaving ? {{W{1'b1}}, {2{~ct8_step[0]}}} : {ct8_step, ~t16_q};
]])
