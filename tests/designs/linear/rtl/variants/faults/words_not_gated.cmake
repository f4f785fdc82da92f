variant("The words are not held at 0 between strobes" M=16 N=13)
replace(linear.v [[assign major = rom11_word & {WORD{strobe}};]] [[assign major = rom11_word;]])
