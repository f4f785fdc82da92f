# The sources of a design as the Verilog that all tools are given.
include_guard(GLOBAL)
include(${CMAKE_CURRENT_LIST_DIR}/../rtl/tool.cmake)

# cosim_verilog_of(VARIABLE WHAT TOP FOLDER SHAPE "NAME,..." FILE...): the files, with those of VHDL as
# one of Verilog, and in place of those with instances of the blackboxes NAME or with inout ports copies
# (tb/rtl/plain_verilog.h), written into FOLDER for the shape "W=8 MODE=FAST". Where one of the files changes
# CMake runs again. An error is one line that begins with WHAT.
function(cosim_verilog_of variable what top folder shape blackboxes)
  cosim_rtl_program(program)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${program} verilog ${top} ${folder} "${shape}" "${blackboxes}" ${ARGN}
    RESULT_VARIABLE status ERROR_VARIABLE error OUTPUT_VARIABLE files)
  if(status)
    string(STRIP "${error}" error)
    message(FATAL_ERROR "${what}: ${error}")
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARGN})
  string(REGEX MATCHALL "[^\n]+" files "${files}")
  set(${variable} ${files} PARENT_SCOPE)
endfunction()
