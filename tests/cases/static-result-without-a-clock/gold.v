// The result of the function keeps its value from call to call where x is 0.
module t(input a,b, output y); function f(input x, z); if (x) f = z; endfunction assign y = f(a,b); endmodule
