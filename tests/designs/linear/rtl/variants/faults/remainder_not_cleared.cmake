variant("No reset reaches register 5" M=5 N=2)
replace(linear.v [[
    if (clear_work) register5_q <= {GAMMA{1'b0}};
    else if (load_bp) register5_q <= data[GAMMA-1:0];
]] [[
    if (load_bp) register5_q <= data[GAMMA-1:0];
]])
