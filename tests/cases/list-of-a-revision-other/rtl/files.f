t.v
one.v
+define+BY=1
