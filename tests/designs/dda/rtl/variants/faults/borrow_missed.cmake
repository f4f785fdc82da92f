variant("A negative rate steps where there is a carry" W=6)

replace(dda_axis.v [[
  assign down = may_step & ~carry & rate[W];
]] [[
  assign down = may_step & carry & rate[W];
]])
