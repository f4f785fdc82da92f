package p;
  typedef enum logic [1:0] {A, B} e;
endpackage
module part #(parameter int DEPTH = 4) (input logic [7:0] d, output logic [7:0] q);
  assign q = d + 8'(DEPTH);
endmodule
module t #(parameter int D = 4) (input logic [7:0] d, input p::e s, output logic [7:0] q);
  logic [7:0] r;
  part #(.DEPTH(D)) u(.d, .q(r));
  assign q = s == p::A ? r : d;
endmodule
