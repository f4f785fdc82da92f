variant("The low bit of register 3 is stuck at 0" M=16 N=13)
replace(linear.v [[register3_q <= data[N-1:0];]] [[register3_q <= {data[N-1:1], 1'b0};]])
