// the old RTL
+incdir+inc+nowhere  # a folder that is not there
+define+OFFSET=$OFFSET
-y lib +libext+.v -sv
/* t.v
   is in the other list */
-F inc/more.f
