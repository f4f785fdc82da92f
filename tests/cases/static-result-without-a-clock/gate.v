module t(input a,b, output y); function f(input x, z); if (x) f = z; endfunction assign y = a & b; endmodule
