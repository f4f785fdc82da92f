variant("The end is seen only after a word" M=5 N=2)
replace(linear_control.v
  [[assign clear_work = reset | ~initial_set_n | (trigger31_q & carry);]]
  [[assign clear_work = reset | ~initial_set_n | (trigger30_q & carry);]])
