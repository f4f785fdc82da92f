variant("AND 33 is missing: a start is taken with no code loaded" M=5 N=2)
replace(linear_control.v
  [[wire begin_work = idle & start & trigger32_q & ~write_bp & ~write_uk;]]
  [[wire begin_work = idle & start & ~write_bp & ~write_uk;]])
