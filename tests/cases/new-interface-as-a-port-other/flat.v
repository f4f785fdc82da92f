module made_top(input clk, input rst, input [3:0] s_data, input s_valid, output s_ready,
                output reg [3:0] m_data, output reg m_valid, input m_ready);
  assign s_ready = m_ready;
  always @(posedge clk) begin
    if (s_ready & !rst) m_data <= s_data;
    m_valid <= rst ? 1'b0 : s_ready ? s_valid : m_valid;
  end
endmodule
