// cosim_rtl: what CMake asks of RTL before there is a program of the project.
#include "tb/rtl/answer.h"

int main(int argc, char** argv) { return cosim::rtl::answer({argv + 1, argv + argc}); }
