variant("L2: counter 4 has n bits" M=5 N=2)

replace(linear_counter4.v [[
    else if (up | down) counter4_q <= counter4_q + step;
]] [[
    else if (up | down) counter4_q <= {1'b0, counter4_q[N-1:0] + step[N-1:0]};
]])
