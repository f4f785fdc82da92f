variant("A code is taken on the clock that takes BP" M=5 N=2)

replace(linear_control.v [[
  assign load_uk = idle & write_uk & ~write_bp;
]] [[
  assign load_uk = idle & write_uk;
]])
