variant("C4: AND 22 looks for 1..11 and AND 23 for 1..101" W=16)
replace(circular.v [[
    .ct8_negative(ct8_q[W]),
    .ct8_lowest(ct8_q[0]),
    .t4_q(t4_q),
]] [[
    .ct8_negative(&ct8_q | (&ct8_q[W:2] & (ct8_q[1:0] == 2'b01))),
    .ct8_lowest(~&ct8_q),
    .t4_q(t4_q),
]])
