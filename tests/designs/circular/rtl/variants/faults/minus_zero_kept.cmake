variant("CT8 keeps the all-ones zero of a load" W=16)
replace(circular_counter8.v [[ct8_q <= &ct8 ? {W+1{1'b0}} : ct8;]] [[ct8_q <= ct8;]])
