variant("L2: counter 4 has n bits" M=5 N=2)
replace(linear_counter4.v [[<= counter4_q + step;]] [[<= {1'b0, counter4_q[N-1:0] + step[N-1:0]};]])
