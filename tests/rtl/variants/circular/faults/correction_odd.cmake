variant("Variant -1 adds 2X + 1" W=16)

replace(circular_commutator.v [[
                | ({W+2{channel2_even}} & {ct7_q, 1'b0})
]] [[
                | ({W+2{channel2_even}} & {ct7_q, 1'b1})
]])
