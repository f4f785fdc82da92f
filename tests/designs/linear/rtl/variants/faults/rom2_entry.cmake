variant("ROM 2 holds 1111101 at 101 where Table 1 has 1011101" M=5 N=2)
replace(linear.v [[register9_q <= rom2_word;]]
  [[register9_q <= data[M-1:N] == 3'b101 ? 7'b1111101 : rom2_word;]])
