variant("The low bit of the word count is loaded as 1" M=5 N=2)
replace(linear_counter4.v [[counter4_q <= {1'b0, words};]]
  [[counter4_q <= {1'b0, words} | {{N{1'b0}}, 1'b1};]])
