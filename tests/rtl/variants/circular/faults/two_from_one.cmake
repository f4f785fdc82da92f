variant("CT8 takes no more for a diagonal step from 1" W=4)

replace(circular_counter8.v [[
  assign ct8_step = down_two ? ct8_q - TWO - {{W{1'b0}}, zero_or_one}
]] [[
  assign ct8_step = down_two ? ct8_q - TWO - {{W{1'b0}}, zero}
]])
