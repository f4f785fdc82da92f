variant("The address of 2 C is read without its highest bit" W=16)
replace(dda.v
  [[if (address == 4'd11) two_c_q <= data;]]
  [[if (address[2:0] == 3'd3) two_c_q <= data;]])
