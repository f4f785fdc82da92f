package b_pkg;
  localparam int W = 5;
endpackage
