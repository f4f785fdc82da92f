module t(input [7:0] d, output q);
  `include "part.svh"
endmodule
