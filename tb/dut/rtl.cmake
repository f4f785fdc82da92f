# What a design's RTL is, before anything is built from it.
include_guard(GLOBAL)
include(${CMAKE_CURRENT_LIST_DIR}/../rtl/tool.cmake)

# cosim_read_rtl(PREFIX WHAT TOP CLOCK FOLDER FILES... OPTIONS word...)
#
# Asks cosim_rtl (tb/rtl/read.h), which asks Verilator and yosys. Sets PREFIX_registers, a line joined by \n for
# each (register_text() of tb/rtl/tool.cpp), PREFIX_resets, the asynchronous ones, "inner NAME" of a register that
# is one, PREFIX_clocks and PREFIX_outputs; PREFIX_unrolled, options that Verilator needs to build it; and PREFIX_hash, of
# all that it read. An error, one line that begins with WHAT, where the RTL has what no design can have.
# OPTIONS are Verilator's.
function(cosim_read_rtl prefix what top clock folder)
  cmake_parse_arguments(PARSE_ARGV 5 R "" "" "FILES;OPTIONS")
  cosim_rtl_program(cosim_rtl)
  find_program(COSIM_YOSYS yosys)
  set(yosys "")
  if(COSIM_YOSYS)
    set(yosys ${COSIM_YOSYS})
  endif()
  execute_process(
    COMMAND ${cosim_rtl} read ${VERILATOR_BIN} "${yosys}" ${top} ${clock} ${folder} ${R_OPTIONS} ${R_FILES}
    RESULT_VARIABLE status ERROR_VARIABLE error)
  if(status)
    string(STRIP "${error}" error)
    message(FATAL_ERROR "${what}: ${error}")
  endif()
  include(${folder}/found.cmake)
  if(found_language)
    message(STATUS "${what}: ${found_language}")
  endif()
  if(found_doubt)
    message(WARNING "${found_doubt} may be in a combinational loop; yosys, which could tell, is missing or "
      "cannot read the RTL")
  endif()
  # RTL that has changed, included files too, is read again before it is built.
  if(NOT CMAKE_SCRIPT_MODE_FILE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${found_sources})
  endif()
  file(SHA256 ${folder}/plain.sv hash)
  set(${prefix}_hash ${hash} PARENT_SCOPE)
  foreach(one registers resets clocks outputs unrolled)
    set(${prefix}_${one} "${found_${one}}" PARENT_SCOPE)
  endforeach()
endfunction()

# cosim_words_for_tools(WHAT WORD...): an error where a WORD, a top module, a clock, a definition or a
# folder, is no word to yosys, which takes it as it stands and would read a command in it.
function(cosim_words_for_tools what)
  foreach(word IN LISTS ARGN)
    if(word MATCHES "[ \t\r\n\";]|^#")
      message(FATAL_ERROR "${what}: yosys cannot be given the name '${word}'")
    endif()
  endforeach()
endfunction()
