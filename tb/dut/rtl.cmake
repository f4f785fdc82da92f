# What a design's RTL is, before anything is built from it: cosim_read_rtl() asks Verilator and cosim_rtl.
include_guard(GLOBAL)
include(${CMAKE_CURRENT_LIST_DIR}/../rtl/tool.cmake)

# cosim_read_rtl(PREFIX WHAT TOP CLOCK FOLDER FILES... OPTIONS word... YOSYS commands...)
#
# Sets PREFIX_registers, what cosim_rtl says of the registers (tb/rtl/registers.h), its lines joined by \n,
# PREFIX_resets, the asynchronous ones, "inner NAME" of a register that is one, PREFIX_clocks and PREFIX_outputs; PREFIX_unrolled,
# options that Verilator needs to build it, also where files .v are Verilog-2005 and nothing later; and
# PREFIX_hash, of all that it read. An error, one line that begins
# with WHAT, where the RTL has what no design can have. OPTIONS are Verilator's; YOSYS is what makes yosys
# read the same. Another one where Verilator
# does not write its tree: no design goes unchecked.
function(cosim_read_rtl prefix what top clock folder)
  cmake_parse_arguments(PARSE_ARGV 5 R "" "YOSYS" "FILES;OPTIONS")
  cosim_rtl_program(cosim_rtl)
  file(MAKE_DIRECTORY ${folder})
  set(verilator ${VERILATOR_BIN} --top-module ${top} -Mdir ${folder} -Wno-fatal -Wno-lint -Wno-style
    --no-timing ${R_OPTIONS})
  # In a file .v a word of SystemVerilog may be a name, as a port `do`; others use SystemVerilog in it.
  set(language)
  set(verilog_2005 +1364-2005ext+v)
  file(REMOVE ${folder}/language.txt)
  cosim_tree_options(tree)
  list(APPEND tree ${folder}/tree -Werror-STMTDLY)
  execute_process(COMMAND ${verilator} ${tree} ${R_FILES}
    RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  # Verilator 5.006 can fail in an optimization that it can do without.
  set(plainer)
  if(status AND said MATCHES "Internal Error: [^\n]*V3Dfg")
    set(plainer -fno-dfg)
    list(APPEND verilator ${plainer})
    execute_process(COMMAND ${verilator} ${tree} ${R_FILES}
      RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  endif()
  if(status AND said MATCHES "%Error: ([^\n]*[.]v:[0-9]+:[0-9]+: [^\n]*(syntax error|SystemVerilog)[^\n]*)")
    set(wrong "${CMAKE_MATCH_1}")
    execute_process(COMMAND ${verilator} ${verilog_2005} ${tree} ${R_FILES}
      RESULT_VARIABLE otherwise OUTPUT_QUIET ERROR_QUIET)
    if(NOT otherwise)
      set(status 0)
      set(language ${verilog_2005})
      list(APPEND verilator ${language})
      string(REGEX REPLACE "^[^:]*/" "" wrong "${wrong}")
      file(WRITE ${folder}/language.txt "files .v are read as Verilog-2005, for in SystemVerilog: ${wrong}")
      message(STATUS "${what}: files .v are read as Verilog-2005, for in SystemVerilog: ${wrong}")
      cosim_yosys_by_kind(R_YOSYS "${R_YOSYS}")
    endif()
  endif()
  if(status)
    string(REGEX MATCH "%Error[^\n]*" error "${said}")
    if(error MATCHES "([^ /]+:[0-9]+):[0-9]+: Cannot find file containing module: '([^']+)'")
      message(FATAL_ERROR "${what}: ${CMAKE_MATCH_1}: no file has the module ${CMAKE_MATCH_2}: give a file that "
        "models it, or make a blackbox of it, whose pins become ports: cosim new --blackbox ${CMAKE_MATCH_2}, in "
        "CMake BLACKBOXES ${CMAKE_MATCH_2}")
    endif()
    if(error MATCHES "Error-(NOTIMING|STMTDLY): ([^ ]*/)?([^ /:]+:[0-9]+):")
      message(FATAL_ERROR "${what}: ${CMAKE_MATCH_3}: waits, as a testbench does and no circuit. Only the delay of "
        "an assignment (q <= #1 d) is left out")
    endif()
    if(error MATCHES "Parameter without (initial|default) value is never given value[^']*'([^']*)'")
      message(FATAL_ERROR "${what}: the parameter ${CMAKE_MATCH_2} has no value of its own: give it one: cosim new "
        "--param ${CMAKE_MATCH_2}=VALUE, in CMake SHAPES \"${CMAKE_MATCH_2}=VALUE\"")
    endif()
    if(error MATCHES "([^ /:]+:[0-9]+):[0-9]+: Unsupported: Member call on object '[A-Z]+ '([^']*)'' which is a")
      message(FATAL_ERROR "${what}: ${CMAKE_MATCH_1}: ${CMAKE_MATCH_2} has no members: its type may be a parameter "
        "of the top: cosim new --param TYPE=PACKAGE::STRUCT")
    endif()
    set(place "([^ /:]+:[0-9]+):[0-9]+:")
    if(error MATCHES "${place} Cannot find include file: '?([^']*)")
      message(FATAL_ERROR "${what}: ${CMAKE_MATCH_1}: no folder has the header ${CMAKE_MATCH_2}: cosim new --include "
        "DIR, in CMake INCLUDE_DIRS DIR")
    endif()
    if(error MATCHES "${place} (Package/class '([^']+)' not found|[^\n]*[Pp]ackage[^\n]* not found: '([^']+)')")
      message(FATAL_ERROR "${what}: ${CMAKE_MATCH_1}: no file has the package ${CMAKE_MATCH_3}${CMAKE_MATCH_4}: give its file, too")
    endif()
    if(error MATCHES "${place} Define or directive not defined: '`([^']+)'")
      message(FATAL_ERROR "${what}: ${CMAKE_MATCH_1}: no file defines the macro ${CMAKE_MATCH_2}: give the file that "
        "does, or cosim new --define ${CMAKE_MATCH_2}, in CMake DEFINES ${CMAKE_MATCH_2}")
    endif()
    if(error MATCHES "${place} Unsupported: Interfaced port on top level module")
      message(FATAL_ERROR "${what}: ${CMAKE_MATCH_1}: an interface is a port of the top: give a module around it whose "
        "ports are signals")
    endif()
    message(FATAL_ERROR "${what}: Verilator cannot read it: ${error}")
  endif()
  # What it warns of, be it told in the RTL not to; a latch that is meant to be one is one too.
  list(FILTER R_FILES EXCLUDE REGEX "[.]vlt$")
  execute_process(COMMAND ${verilator} -E ${R_FILES}
    OUTPUT_FILE ${folder}/plain.sv ERROR_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  # RTL that has changed, included files too, is read again before it is built.
  file(STRINGS ${folder}/plain.sv read REGEX "^`line [0-9]+ \"/")
  list(TRANSFORM read REPLACE "^`line [0-9]+ \"(.*)\".*$" "\\1")
  list(REMOVE_DUPLICATES read)
  if(NOT CMAKE_SCRIPT_MODE_FILE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${read})
  endif()
  set(by_language "")
  if(language)
    set(by_language "${R_FILES}")
  endif()
  execute_process(COMMAND ${cosim_rtl} warnings ${folder}/plain.sv "${by_language}" COMMAND_ERROR_IS_FATAL ANY)
  file(SHA256 ${folder}/plain.sv hash)
  set(${prefix}_hash ${hash} PARENT_SCOPE)
  # What writes an array with `<=` in a loop must be unrolled; the loops of others had better not be.
  foreach(unrolled "" "--unroll-count;65536;--unroll-stmts;1000000")
    execute_process(
      COMMAND ${verilator} ${unrolled} --lint-only -Wwarn-LATCH -Wwarn-UNOPTFLAT ${folder}/plain.sv
      RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
    set(${prefix}_unrolled ${language} ${plainer} ${unrolled} PARENT_SCOPE)
    if(NOT said MATCHES "%Error-BLKLOOPINIT")
      break()
    endif()
  endforeach()
  if(status)
    string(REGEX MATCH "%Error[^\n]*" error "${said}")
    if(error MATCHES "([^ /:]+:[0-9]+):[0-9]+: Unsupported in C: Variable has same name as instance: '([^']+)'")
      message(FATAL_ERROR "${what}: ${CMAKE_MATCH_1}: ${CMAKE_MATCH_2} is the name of a signal and of its module, which "
        "Verilator cannot simulate: rename one")
    endif()
    message(FATAL_ERROR "${what}: Verilator cannot lint it: ${error}")
  endif()
  file(WRITE ${folder}/warnings.txt "${said}")
  cosim_read_netlist(netlist ${folder} "${R_YOSYS}")
  execute_process(
    COMMAND ${cosim_rtl} registers ${folder}/tree ${folder}/warnings.txt ${clock} ${netlist}
    RESULT_VARIABLE status OUTPUT_VARIABLE found ERROR_VARIABLE error)
  if(status)
    string(STRIP "${error}" error)
    message(FATAL_ERROR "${what}: ${error}")
  endif()
  file(WRITE ${folder}/found.txt "${found}")

  string(REGEX MATCHALL "(^|\n)loop [^\n]*" loops "${found}")
  if(loops AND NOT netlist_has_no_loop)
    list(TRANSFORM loops REPLACE "^\n?loop " "")
    if(NOT netlist)
      set(R_YOSYS "")
    endif()
    cosim_find_loop(loop "${loops}" ${folder}/loop.txt "${R_YOSYS}")
    if(loop)
      message(FATAL_ERROR "${what}: ${loop}: a combinational loop")
    endif()
  endif()
  foreach(what register reset clock output)
    string(REGEX MATCHALL "(^|\n)${what} [^\n]*" lines "${found}")
    list(TRANSFORM lines REPLACE "^\n?${what} " "")
    list(JOIN lines "\\n" lines)
    if(what STREQUAL reset)
      string(REGEX MATCHALL "(^|\n)inner [^\n]*" inner "${found}")
      list(TRANSFORM inner REPLACE "^\n" "")
      list(APPEND lines ${inner})
      list(JOIN lines "\\n" lines)
    endif()
    set(${prefix}_${what}s "${lines}" PARENT_SCOPE)
  endforeach()
endfunction()

# Sets the variable to the options with which Verilator writes its tree into the file that follows: as XML, or, from
# 5.046 on, as JSON (tb/rtl/tree.h).
function(cosim_tree_options variable)
  execute_process(COMMAND ${VERILATOR_BIN} --xml-only --version RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if(status EQUAL 0)
    set(${variable} --xml-only --xml-output PARENT_SCOPE)
  else()
    set(${variable} --json-only --json-only-output PARENT_SCOPE)
  endif()
endfunction()

# Sets the variable to commands of yosys that read files .v as Verilog-2005, and others as SystemVerilog as
# `commands`, which begin with read_verilog -sv OPTIONS "FILE"..., read all of them.
function(cosim_yosys_by_kind variable commands)
  string(REGEX MATCH "^read_verilog -sv ([^\"]*)((\"[^\"]*\" ?)+)(.*)$" _ "${commands}")
  set(options "${CMAKE_MATCH_1}")
  set(rest "${CMAKE_MATCH_4}")
  string(REGEX MATCHALL "\"[^\"]*\"" others "${CMAKE_MATCH_2}")
  set(older ${others})
  list(FILTER older INCLUDE REGEX "[.]v\"$")
  list(FILTER others EXCLUDE REGEX "[.]v\"$")
  list(JOIN older " " all)
  set(all "read_verilog ${options}${all}")
  if(others)
    list(JOIN others " " newer)
    string(PREPEND all "read_verilog -sv ${options}${newer}; ")
  endif()
  set(${variable} "${all}${rest}" PARENT_SCOPE)
endfunction()

# Sets COSIM_RUN_YOSYS, which runs yosys without the history that it keeps in the user's home.
macro(cosim_find_yosys)
  find_program(COSIM_YOSYS yosys)
  set(COSIM_RUN_YOSYS ${CMAKE_COMMAND} -E env --unset=HOME --unset=XDG_STATE_HOME ${COSIM_YOSYS})
endmacro()

# What yosys, where there is one and it reads the RTL in 40 s, says that the RTL holds: sets the variable to its
# netlist as JSON, or to nothing; FOLDER/unread.txt then says why. Sets VARIABLE_has_no_loop where
# there is none even if each bit that a cell gives depends on all that it takes.
function(cosim_read_netlist variable folder commands)
  set(${variable} "" PARENT_SCOPE)
  set(${variable}_has_no_loop FALSE PARENT_SCOPE)
  cosim_find_yosys()
  if(NOT COSIM_YOSYS OR NOT commands)
    return()
  endif()
  # The file is no word of a command, which a folder of any name would not be.
  execute_process(
    COMMAND ${COSIM_RUN_YOSYS} -q -l ${folder}/netlist.log -p "${commands}; proc; flatten; scc" -b json
      -o ${folder}/netlist.json
    TIMEOUT 40 RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE said)
  if(status MATCHES "timeout")
    file(WRITE ${folder}/unread.txt "yosys does not read the RTL in 40 s")
  elseif(NOT status EQUAL 0)
    string(REGEX MATCH "[^\n]*ERROR: [^\n]*" error "${said}")
    string(REGEX REPLACE "^[^:]*/" "" error "${error}")
    string(STRIP "${error}" error)
    file(WRITE ${folder}/unread.txt "yosys cannot read the RTL: ${error}")
  else()
    set(${variable} ${folder}/netlist.json PARENT_SCOPE)
    file(STRINGS ${folder}/netlist.log loops REGEX "^Found [0-9]+ SCCs[.]$")
    if(loops MATCHES "Found 0 SCCs[.]$")
      set(${variable}_has_no_loop TRUE PARENT_SCOPE)
    endif()
  endif()
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

# Verilator takes nets for whole and sees a loop in any carry chain; yosys looks at each bit. Sets the
# variable to a net of a loop, or to nothing.
function(cosim_find_loop variable candidates file commands)
  set(${variable} "" PARENT_SCOPE)
  list(GET candidates 0 first)
  cosim_find_yosys()
  if(COSIM_YOSYS AND commands)
    file(REMOVE ${file})
    # yosys takes no quotation for it: one with odd characters goes by its name in its folder.
    set(place)
    set(name ${file})
    if(NOT file MATCHES "^[A-Za-z0-9_./+-]+$")
      cmake_path(GET file PARENT_PATH folder)
      cmake_path(GET file FILENAME name)
      set(place WORKING_DIRECTORY ${folder})
    endif()
    execute_process(
      COMMAND ${COSIM_RUN_YOSYS} -q -p
        "${commands}; proc; flatten; opt_clean; techmap; opt_clean; scc -select; select -write ${name} %"
      ${place}
      RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
    if(status EQUAL 0)
      if(EXISTS ${file})
        file(STRINGS ${file} nets REGEX "/[^$]*$")
        foreach(net IN LISTS nets)
          string(REGEX REPLACE "^[^/]*/" "" net "${net}")
          set(${variable} ${net} PARENT_SCOPE)
          return()
        endforeach()
        file(STRINGS ${file} cells)
        if(cells)
          set(${variable} ${first} PARENT_SCOPE)
        endif()
      endif()
      return()
    endif()
  endif()
  message(WARNING "${first} may be in a combinational loop; yosys, which could tell, is missing or "
    "cannot read the RTL")
endfunction()
