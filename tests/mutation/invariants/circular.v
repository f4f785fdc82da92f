// While no arc runs F is as loaded or cleared: its fraction is .75, code 11, or 10 below zero.
assign holds = t4_q | f_q[1];
