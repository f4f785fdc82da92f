variant("The low bit of F is loaded as 1" W=16)

replace(circular_accumulator.v [[
    else if (take) f_q <= {f, 1'b1, ~f[W+1]};
]] [[
    else if (take) f_q <= {f[W+1:1], 2'b11, ~f[W+1]};
]])
