variant("A load sets the fraction of F to .00" W=4)

replace(circular_accumulator.v [[
    else if (take) f_q <= {f, 1'b1, ~f[W+1]};
]] [[
    else if (take) f_q <= {f, 2'b00};
]])
