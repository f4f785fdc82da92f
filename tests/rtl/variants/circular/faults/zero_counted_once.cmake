variant("CT7 passes below zero into its second code of zero" W=4)

replace(circular_counter7.v [[
  assign ct7_down = ct7_q - ONE - {{W{1'b0}}, zero};
]] [[
  assign ct7_down = ct7_q - ONE;
]])
