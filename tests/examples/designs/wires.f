wires_part.v
+incdir+include +define+WIRES_STEP=3
