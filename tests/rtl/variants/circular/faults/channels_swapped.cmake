variant("Channels 1 and 3 are each other's" W=4)

replace(circular.v [[
      .channel1(diagonal), .channel2(straight_x | variant2), .channel2_even(variant1),
      .channel3(straight_y), .addend(addend)
]] [[
      .channel1(straight_y), .channel2(straight_x | variant2), .channel2_even(variant1),
      .channel3(diagonal), .addend(addend)
]])
