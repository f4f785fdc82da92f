variant("L8: each write of the code counts the remainder" M=5 N=2)
replace(linear.v
  [[wire add_remainder = load_uk & ~trigger32_q & remainder;]]
  [[wire add_remainder = load_uk & remainder;]])
