module t(input \reg , output \wire ); assign \wire = !\reg ; endmodule
