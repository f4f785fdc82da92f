variant("L8: a write is taken at any time, as its strobe comes" M=5 N=2)
replace(linear_control.v [[
  assign load_bp = idle & write_bp;
  assign load_uk = idle & write_uk & ~write_bp;
]] [[
  assign load_bp = initial_set_n & write_bp;
  assign load_uk = initial_set_n & write_uk & ~write_bp;
]])
