core.v +incdir+. -y ../../lib
--top-module core
