variant("Accumulator 1 drops the carry out of its sign" W=4)

replace(circular_accumulator.v [[
    else           f_q <= sum[W+3:0] + {{(W+3){1'b0}}, sum[W+4]};
]] [[
    else           f_q <= sum[W+3:0];
]])
