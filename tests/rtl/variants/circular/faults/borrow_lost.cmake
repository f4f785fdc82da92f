variant("CT8 has no borrow from bit 7 to bit 8" W=16)

replace(circular_counter8.v [[
                             : ct8_q - ONE - {{W{1'b0}}, zero};
]] [[
                             : {ct8_q[W:8], ct8_q[7:0] - ONE[7:0] - {7'b0, zero}};
]])
