variant("Multiplier 6 takes the code with its low bit first" M=5 N=2)
replace(linear_multiplier6.v
  [[assign chosen[j-1] = rising[j-1] & code[N-j];]]
  [[assign chosen[j-1] = rising[j-1] & code[j-1];]])
