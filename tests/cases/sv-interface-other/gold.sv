// An interface with modports between two modules.
interface link;
  logic [3:0] data;
  logic valid;
  modport source(output data, valid);
  modport sink(input data, valid);
endinterface
module producer(input [3:0] a, link.source l);
  assign l.data = ~a;
  assign l.valid = |a;
endmodule
module consumer(link.sink l, output [3:0] y);
  assign y = l.valid ? l.data : 4'd0;
endmodule
module t(input [3:0] a, output [3:0] y);
  link l();
  producer p(a, l);
  consumer c(l, y);
endmodule
