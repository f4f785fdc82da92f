interface bus #(parameter int W = 2);
  logic [W-1:0] data;
  logic valid, ready;
  modport target(input data, valid, output ready);
  modport source(output data, valid, input ready);
endinterface
