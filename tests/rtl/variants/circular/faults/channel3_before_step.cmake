variant("Channel 3 has CT7 as it was before the step" W=16)

replace(circular_commutator.v [[
                | ({W+2{channel3}} & {~ct7_up, 1'b0});
]] [[
                | ({W+2{channel3}} & {~ct7_q, 1'b0});
]])
