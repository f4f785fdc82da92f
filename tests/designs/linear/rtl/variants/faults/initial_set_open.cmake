variant("Input 17 is not wired to the registers" M=16 N=13)
replace(linear_control.v
  [[assign clear_work = reset | ~initial_set_n | (trigger31_q & carry);]]
  [[assign clear_work = reset | (trigger31_q & carry);]])
