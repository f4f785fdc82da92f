variant("C5: channel 1 gives -0 for the diagonal step to X - Y = 0" W=4)
replace(circular_commutator.v [[& ~ct8_zero_or_one)]] [[& (~ct8_zero_or_one | ct8_lowest))]])
