variant("L8: input 17 clears the control unit and the multiplier alone" M=5 N=2)
replace(linear.v
  [[if (clear_work) register5_q <= {GAMMA{1'b0}};]]
  [[if (reset) register5_q <= {GAMMA{1'b0}};]])
replace(linear.v [[
    .clear(clear_work),
    .load(load_bp),
]] [[
    .clear(reset),
    .load(load_bp),
]])
