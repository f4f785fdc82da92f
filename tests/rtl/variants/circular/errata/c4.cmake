variant("C4: AND 22 looks for 1..11 and AND 23 for 1..101" W=16)

replace(circular.v [[
      .f_negative(f_q[W+3]), .ct7_negative(ct7_q[W]), .ct8_negative(ct8_q[W]), .ct8_odd(~ct8_q[0]),
]] [[
      .f_negative(f_q[W+3]), .ct7_negative(ct7_q[W]),
      .ct8_negative(&ct8_q | (&ct8_q[W:2] & (ct8_q[1:0] == 2'b01))), .ct8_odd(&ct8_q),
]])
