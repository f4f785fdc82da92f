# Designs, as a project adds them:
#
#   cosim_add_design(NAME
#     SOURCES file.v...            Verilog or SystemVerilog that Verilator reads; VHDL (.vhd, .vhdl), which
#                                  GHDL converts to Verilog
#     [FILELIST list.f...]         files, +incdir+ and +define+ of these lists, too; their paths begin at the
#                                  folder of the list, tb/rtl/file_list.h
#     [TOP module]                 the top module; default NAME
#     [CLOCK port | CLOCKS port... | COMBINATIONAL]
#                                  its clock, default clk; or several clocks; or it has no register
#     [INCLUDE_DIRS folder...] [DEFINES name[=value]...]
#     MODEL header...              the struct that is its golden model, model/clocked/model.h, or its stream
#                                  model, model/clocked/stream.h
#     [STRUCT name]                the struct's name; default NAME in one word, AsyncFifo for async_fifo
#     [SHAPES "W=8 M=8'h1F"...]    configurations, one build each: numbers, constants and words (MODE=FAST is
#                                  a text) for parameters of the top; default those of the RTL
#     [MODEL_SHAPES "W=5"...]      more configurations of the struct alone, for tests that run it without RTL
#     [NETLISTS file.v...]         one for each shape, simulated in place of SOURCES; its registers are wires
#     [LIBRARIES target...]        libraries that the model needs besides its headers
#     [UNPROVED])                  no proof: the model cannot be exported, or yosys cannot read the RTL. A
#                                  stream model alone is never proved
#
#   cosim_add_program(TARGET       a program with every command for all designs added so far
#     [SOURCES file.cpp...] [LIBRARIES target...]
#     [REGISTER name...]           calls cosim::name::add_to(registry), which adds commands, tb/cli/registry.h
#     [THEOREMS name...]           calls cosim::name::theorems(), tb/proof/theorems.h
#     [JOBS design=header...])     more work with which its mutants are attacked, tb/mutation/cases.h
#   cosim_add_tests(TARGET         CTest tests of its designs, each with its kind as its label:
#     [HOSTILE clocks]             NAME.hostile, that many unconstrained random clocks for each shape,
#                                  default 100000; NAME.proof, unless it is UNPROVED
#     [RANDOM jobs]                NAME.random, that many random jobs for each shape, if it has jobs
#     [MUTANTS n]                  NAME.mutants, that many mutants for each shape, each killed or proved
#                                  equal; not for a design that is UNPROVED
#     [REGRESSIONS folder])        NAME.regression.FILE, for each FILE.stim in the folder: RTL and
#                                  model must not differ on it
#
# The parameters of a shape are the template parameters of the struct, by their position: integers, or
# Text. Paths are relative to the calling folder. RTL with a clock that is no input, with both edges of a
# clock, a latch, a combinational loop or a bidirectional port is refused in a line that names the net.
#
# A single clock rises on each step and is no input of the model. Each of several clocks, and a single one
# whose falling edge is used, is a member Rises or Falls of In: 1 on a step on which that edge comes.
include_guard(GLOBAL)
include(${CMAKE_CURRENT_LIST_DIR}/../dut/ports.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/../dut/rtl.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/../dut/shape.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/../dut/verilog.cmake)
set_property(GLOBAL PROPERTY COSIM_ROOT "${CMAKE_CURRENT_LIST_DIR}/../..")
include(${CMAKE_CURRENT_LIST_DIR}/design_control.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/design_open.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/design_struct.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/design_program.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/design_gtest.cmake)  # cosim_add_gtest(): tests by hand
include(${CMAKE_CURRENT_LIST_DIR}/design_cover.cmake)

# Files that are there, as absolute paths.
function(cosim_files variable what)
  set(all)
  foreach(file IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    if(NOT EXISTS ${file})
      message(FATAL_ERROR "${what}: no such file: ${file}")
    endif()
    list(APPEND all ${file})
  endforeach()
  set(${variable} ${all} PARENT_SCOPE)
endfunction()

# Adds what the lists of FILELIST name to SOURCES, INCLUDE_DIRS and DEFINES of cosim_add_design().
macro(cosim_file_lists)
  if(D_FILELIST)
    cosim_rtl_program(program)
    cosim_files(lists "${what}: FILELIST" ${D_FILELIST})
    execute_process(COMMAND ${program} lists ${lists}
      OUTPUT_VARIABLE said ERROR_VARIABLE error RESULT_VARIABLE status)
    if(status)
      string(STRIP "${error}" error)
      message(FATAL_ERROR "${what}: ${error}")
    endif()
    string(REGEX MATCHALL "[^\n]+" said "${said}")
    foreach(line IN LISTS said)
      string(REGEX MATCH "^([A-Z_]+) (.*)$" line "${line}")
      list(APPEND D_${CMAKE_MATCH_1} "${CMAKE_MATCH_2}")
    endforeach()
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${D_LISTS})
  endif()
endmacro()

# Many small files, most of whose time to compile is Verilator's header: compiled some classes at a
# time. Newer Verilators refuse two classes in one file, by a macro, for the sake of precompiled
# headers, which are not used here.
function(cosim_verilated_library target)
  add_library(${target} ${ARGN})
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX
    UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 40
    UNITY_BUILD_CODE_AFTER_INCLUDE "#undef VL_PCH_INCLUDED")
  target_compile_options(${target} PRIVATE -w)  # a user's flags are for a user's code
endfunction()

function(cosim_add_design NAME)
  if(NOT VERILATOR_ROOT)
    find_package(verilator REQUIRED HINTS $ENV{VERILATOR_ROOT} /usr/share/verilator)
  endif()
  cmake_parse_arguments(PARSE_ARGV 1 D "UNPROVED;COMBINATIONAL" "TOP;CLOCK;STRUCT"
    "CLOCKS;BLACKBOXES;SOURCES;FILELIST;INCLUDE_DIRS;DEFINES;MODEL;SHAPES;MODEL_SHAPES;NETLISTS;LIBRARIES")
  set(what "cosim_add_design(${NAME})")
  if(D_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "${what}: unknown argument ${D_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT NAME MATCHES "^[A-Za-z][A-Za-z0-9_]*$")
    message(FATAL_ERROR "${what}: names are letters, digits and _, a letter first")
  endif()
  cosim_file_lists()
  foreach(needed SOURCES MODEL)
    if(NOT D_${needed})
      message(FATAL_ERROR "${what}: needs ${needed}")
    endif()
  endforeach()
  if(D_STRUCT AND NOT D_STRUCT MATCHES "^[A-Za-z_][A-Za-z0-9_]*(::[A-Za-z_][A-Za-z0-9_]*)*$")
    message(FATAL_ERROR "${what}: STRUCT: names are letters, digits and _: ${D_STRUCT}")
  endif()
  set(TOP ${NAME})
  if(D_TOP)
    set(TOP ${D_TOP})
  endif()
  set(CLOCK clk)
  if(D_CLOCK)
    set(CLOCK ${D_CLOCK})
  endif()
  set(reader_clock ${CLOCK})
  if(D_CLOCKS)
    if(D_CLOCK)
      message(FATAL_ERROR "${what}: CLOCK does not go with CLOCKS")
    endif()
    set(CLOCK "")
    list(JOIN D_CLOCKS "," reader_clock)
    string(APPEND reader_clock ",")
  endif()
  if(D_COMBINATIONAL)
    if(D_CLOCK OR D_CLOCKS)
      message(FATAL_ERROR "${what}: COMBINATIONAL does not go with CLOCK")
    endif()
    set(CLOCK "")
    set(reader_clock -)
  endif()
  if(NOT D_SHAPES)
    set(D_SHAPES " ")
  endif()
  list(LENGTH D_SHAPES shapes)
  list(LENGTH D_NETLISTS netlists)
  if(D_NETLISTS AND NOT shapes EQUAL netlists)
    message(FATAL_ERROR "${what}: ${netlists} NETLISTS for ${shapes} SHAPES")
  endif()
  cosim_files(sources "${what}: SOURCES" ${D_SOURCES})
  cosim_files(netlists "${what}: NETLISTS" ${D_NETLISTS})
  cosim_files(model "${what}: MODEL" ${D_MODEL})
  cosim_files(folders "${what}: INCLUDE_DIRS" ${D_INCLUDE_DIRS})

  set(MODEL_INCLUDES "")
  set(model_text "")
  foreach(header IN LISTS model)
    file(READ ${header} text)
    string(APPEND model_text "${text}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
    string(APPEND MODEL_INCLUDES "#include \"${header}\"\n")
  endforeach()
  cosim_struct()
  if(model_text MATCHES "\n *struct Job ")
    set_property(GLOBAL APPEND PROPERTY COSIM_WITH_JOBS ${NAME})
  endif()
  set(options)
  set(included)
  foreach(folder IN LISTS folders)
    list(APPEND options -I${folder})
    file(GLOB more CONFIGURE_DEPENDS ${folder}/*)
    list(APPEND included ${more})
  endforeach()
  foreach(define IN LISTS D_DEFINES)
    list(APPEND options -D${define})
  endforeach()
  cosim_words_for_tools("${what}" ${TOP} ${CLOCK} ${D_CLOCKS} ${D_DEFINES} ${folders})
  list(JOIN D_BLACKBOXES "," blackboxes)
  list(JOIN folders "\", \"" FOLDERS)
  list(JOIN D_DEFINES "\", \"" DEFINES)
  foreach(list FOLDERS DEFINES)
    if(${list})
      set(${list} "\"${${list}}\"")
    endif()
  endforeach()
  cosim_rtl_program(program)
  string(TOLOWER "${D_UNPROVED}" UNPROVED)  # true or false, for C++

  get_property(root GLOBAL PROPERTY COSIM_ROOT)
  # For long runs: of the registers alone it is told where they are. And with the whole hierarchy open,
  # for replays and waves: several times slower, and built when the first of them asks for it.
  cosim_verilated_library(${NAME}_verilated STATIC)
  cosim_verilated_library(${NAME}_open MODULE EXCLUDE_FROM_ALL)
  # What looks like a name that a model may have, and is none, is an error when it is built.
  set(names ${CMAKE_CURRENT_BINARY_DIR}/${NAME}.names)
  add_custom_command(OUTPUT ${names} DEPFILE ${names}.d VERBATIM
    COMMAND ${program} names ${names} ${root} ${model}
    DEPENDS ${program} COMMENT "Names of ${NAME}")
  target_sources(${NAME}_verilated PRIVATE ${names})
  foreach(text SHAPES VERILATED_INCLUDES OPEN_INCLUDES OPEN_MAKERS open_made_of ADD_BENCHES ADD_MACHINES prefixes struct_shapes struct_parameters struct_files struct_paths EXPORTS)
    set(${text} "")
  endforeach()
  set(shape_number 0)
  foreach(shape IN LISTS D_SHAPES)
    cosim_shape(shape "${what}" "${shape}")
    string(REGEX REPLACE "[ =]" "" ID "${NAME}${shape}")
    string(MAKE_C_IDENTIFIER "${ID}" ID)
    string(LENGTH "${ID}" length)
    if(length GREATER 100)  # names of files are made of it
      string(SHA256 ID "${ID}")
      string(SUBSTRING ${ID} 0 16 ID)
      set(ID ${NAME}_${ID})
    endif()
    string(STRIP "${NAME} ${shape_title}" TITLE)
    set(generics ${shape_generics})
    cosim_verilog_of(rtl "cosim_add_design(${TITLE})" ${TOP} ${CMAKE_CURRENT_BINARY_DIR}/rtl_${ID}
      "${shape_title}" "${blackboxes}" ${sources})
    list(JOIN rtl "\", \"" FILES)
    cosim_read_rtl(rtl_of "cosim_add_design(${TITLE})" ${TOP} ${reader_clock}
      ${CMAKE_CURRENT_BINARY_DIR}/rtl_${ID} FILES ${rtl} OPTIONS ${generics} ${options})
    if(rtl_of_resets MATCHES "inner (low )?([^\\]*)" AND NOT D_UNPROVED)
      message(FATAL_ERROR "cosim_add_design(${TITLE}): ${CMAKE_MATCH_2}: a register is an asynchronous "
        "reset: write UNPROVED, because nothing can be proved of such a design")
    endif()
    set(verilated ${rtl})
    set(verilated_options ${generics} ${options})
    if(netlists)
      list(POP_FRONT netlists verilated)
      set(verilated_options)
    endif()
    list(APPEND verilated_options -Wno-fatal --no-timing ${rtl_of_unrolled} --x-initial unique --x-assign unique --assert --vpi)
    cosim_control_file(control ${ID} "${rtl_of_registers}" "${model_text}")
    verilate(${NAME}_verilated PREFIX V${ID} TOP_MODULE ${TOP}
      SOURCES ${control} ${verilated} VERILATOR_ARGS ${verilated_options} -O3)
    verilate(${NAME}_open PREFIX I${ID} TOP_MODULE ${TOP}
      SOURCES ${verilated} VERILATOR_ARGS ${verilated_options} --public-flat-rw)
    list(APPEND prefixes ${ID})
    string(APPEND VERILATED_INCLUDES "#include \"V${ID}_ports.h\"\n")
    string(APPEND OPEN_INCLUDES "#include \"I${ID}_ports.h\"\n")
    string(APPEND OPEN_MAKERS
      "extern \"C\" cosim::OpenInstance* open_${ID}(std::uint32_t power_up) {\n"
      "  return new cosim::OpenInstanceOf<I${ID}, true>(power_up);\n"
      "}\n")
    set(netlist_hash)
    if(D_NETLISTS)
      file(SHA256 ${verilated} netlist_hash)
    endif()
    string(APPEND open_made_of "${ID} ${rtl_of_hash} ${netlist_hash} ${verilated_options}\n")
    if(NOT D_CLOCKS)
      set(rtl_of_clocks "")
    endif()
    cosim_struct_shape()
    string(APPEND SHAPES
      "struct Trait_${ID} {\n"
      "  using Design = ::${design_namespace}::Design;\n"
      "  static constexpr Design::Params params{${shape_values}};\n"
      "  static constexpr const char* title = \"${TITLE}\";\n"
      "  static constexpr const char* id = \"${ID}\";\n"
      "  static constexpr const char* clock = \"${CLOCK}\";\n"
      "  static constexpr const char* clocks = \"${rtl_of_clocks}\";\n"
      "  static constexpr const char* registers = \"${rtl_of_registers}\";\n"
      "  static constexpr const char* resets = \"${rtl_of_resets}\";\n"
      "  static constexpr const char* outputs = \"${rtl_of_outputs}\";\n"
      "${trait_model}"
      "};\n")
    string(APPEND ADD_BENCHES "  add_benches(all, add_shape<V${ID}, Trait_${ID}, open_library>);\n")
    string(APPEND ADD_MACHINES
      "  all.push_back(proof::built_machine<Trait_${ID}>(\n"
      "      {{\"${FILES}\"}, \"${TOP}\", {}, {}, {${FOLDERS}}, {${DEFINES}}, {${shape_constants}}}));\n")
    cosim_shape_cover()
  endforeach()
  list(TRANSFORM prefixes PREPEND V OUTPUT_VARIABLE classes)
  cosim_ports(${NAME}_verilated ${classes})
  list(TRANSFORM prefixes PREPEND I OUTPUT_VARIABLE classes)
  cosim_ports(${NAME}_open ${classes})
  cosim_without_runtime(${NAME}_verilated ${NAME}_open)
  cosim_open_library("${open_made_of}")
  cosim_struct_design()
  # The lockstep of all shapes is one file, and what is proved of them another.
  configure_file(${root}/tb/package/named_shapes.h.in ${CMAKE_CURRENT_BINARY_DIR}/${NAME}_shapes.h @ONLY)
  foreach(kind benches machines)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${NAME}_${kind}.cpp)
    configure_file(${root}/tb/package/named_${kind}_of.cpp.in ${source} @ONLY)
    set_property(GLOBAL APPEND PROPERTY COSIM_SOURCES_OF_${kind} ${source})
  endforeach()
  set_property(GLOBAL APPEND PROPERTY COSIM_VERILATED ${NAME}_verilated)
  set_property(GLOBAL APPEND PROPERTY COSIM_LIBRARIES ${D_LIBRARIES})
  set_property(GLOBAL APPEND PROPERTY COSIM_DESIGNS ${NAME})
  set_property(GLOBAL PROPERTY COSIM_NAMESPACE_OF_${NAME} ${design_namespace})
  if(D_UNPROVED)
    set_property(GLOBAL APPEND PROPERTY COSIM_UNPROVED ${NAME})
  endif()
endfunction()

# cosim_without_runtime(TARGET...): takes Verilator's own library, which verilate() puts into every
# target, out of it: cosim::runtime has it.
function(cosim_without_runtime)
  foreach(target IN LISTS ARGN)
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources EXCLUDE REGEX "^${VERILATOR_ROOT}/include/")
    set_property(TARGET ${target} PROPERTY SOURCES ${sources})
  endforeach()
endfunction()

# The CTest test NAME.KIND, with KIND as its label.
function(cosim_test name kind)
  add_test(NAME ${name} COMMAND ${ARGN})
  set_tests_properties(${name} PROPERTIES LABELS ${kind})
endfunction()

function(cosim_add_tests TARGET)
  cmake_parse_arguments(PARSE_ARGV 1 T "" "HOSTILE;RANDOM;MUTANTS;REGRESSIONS" "")
  set(what "cosim_add_tests(${TARGET})")
  if(T_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "${what}: unknown argument ${T_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT TARGET ${TARGET})
    message(FATAL_ERROR "${what}: no program of this name: cosim_add_program(NAME_cosim) adds one")
  endif()
  if(NOT T_HOSTILE)
    set(T_HOSTILE 100000)
  endif()
  foreach(number HOSTILE RANDOM MUTANTS)
    if(T_${number} AND NOT T_${number} MATCHES "^[1-9][0-9]*$")
      message(FATAL_ERROR "${what}: ${number} is ${T_${number}}, not a number from 1 on")
    endif()
  endforeach()
  get_property(designs GLOBAL PROPERTY COSIM_DESIGNS)
  get_property(unproved GLOBAL PROPERTY COSIM_UNPROVED)
  get_property(with_jobs GLOBAL PROPERTY COSIM_WITH_JOBS)
  foreach(name IN LISTS designs)
    cosim_test(${name}.hostile hostile ${TARGET} sweep ${name} --hostile ${T_HOSTILE})
    if(T_RANDOM AND name IN_LIST with_jobs)
      cosim_test(${name}.random random ${TARGET} sweep ${name} --random ${T_RANDOM})
    endif()
    if(NOT name IN_LIST unproved)
      cosim_test(${name}.proof proof ${TARGET} prove ${name})
      set_tests_properties(${name}.proof PROPERTIES SKIP_REGULAR_EXPRESSION "needs (yosys|cec)")
      if(T_MUTANTS)
        cosim_test(${name}.mutants mutants ${TARGET} mutate ${name} --mutants ${T_MUTANTS})
        # It builds, and has what the machine gives.
        set_tests_properties(${name}.mutants PROPERTIES RUN_SERIAL ON
          SKIP_REGULAR_EXPRESSION "needs (yosys|cec)")
      endif()
    endif()
  endforeach()
  if(T_REGRESSIONS)
    cosim_files(folder "${what}: REGRESSIONS" ${T_REGRESSIONS})
    file(GLOB stimuli CONFIGURE_DEPENDS ${folder}/*.stim)
    foreach(file IN LISTS stimuli)
      file(STRINGS ${file} machine REGEX "^machine [^ ]+" LIMIT_COUNT 1)
      string(REGEX REPLACE "^machine ([^ ]+).*$" "\\1" name "${machine}")
      if(NOT name IN_LIST designs)
        message(FATAL_ERROR "${what}: ${file} is no stimulus of a design: it has no line machine NAME")
      endif()
      cmake_path(GET file STEM stem)
      cosim_test(${name}.regression.${stem} regression ${TARGET} replay ${file})
    endforeach()
  endif()
endfunction()
