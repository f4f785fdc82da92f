// Attributes at a module, a port, a net, a process, an operator and a connection.
(* top *) module t((* mark = 1 *) input clk, input [1:0] a, output reg y);
  (* keep, syn_keep = "true" *) wire n = a[0] & (* fast *) a[1];
  (* process *) always @(posedge clk) (* statement *) y <= n;
endmodule
