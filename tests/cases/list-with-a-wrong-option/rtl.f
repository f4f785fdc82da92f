t.v

--build t.cpp
