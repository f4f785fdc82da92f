variant("ROM 11 has one position too few for every remainder" M=5 N=2)
replace(linear_rom11.v
  [[assign word[WORD-p] = chip_select | (address >= POSITION);]]
  [[assign word[WORD-p] = chip_select | (address > POSITION);]])
