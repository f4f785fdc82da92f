// Between lines nothing is formed and multiplier 6 rests.
assign holds = trigger31_q | ~(trigger30_q | trigger10_q | (|multiplier6_q));
