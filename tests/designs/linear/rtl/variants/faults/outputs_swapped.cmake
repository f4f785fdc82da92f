variant("The words of the two axes are on each other's pins" M=5 N=2)
replace(linear.v [[
  assign major = rom11_word & {WORD{strobe}};
  assign minor = {register9_q, trigger10_q} & major;
]] [[
  assign minor = rom11_word & {WORD{strobe}};
  assign major = {register9_q, trigger10_q} & minor;
]])
