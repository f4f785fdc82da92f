# Designs, as a project adds them:
#
#   cosim_add_design(NAME
#     SOURCES file.v...            Verilog or SystemVerilog that Verilator reads
#     [TOP module]                 the top module; default NAME
#     [CLOCK port]                 its clock; default clk
#     [INCLUDE_DIRS folder...] [DEFINES name[=value]...]
#     MODEL header...              what defines struct cosim::NAME::Design
#     [SHAPES "W=8 M=8'h1F"...]    parameters of the top, one build each: numbers, constants, words
#                                  (MODE=FAST is a text); none: as the RTL has them
#     [UNPROVED])                  no proof: the model is plain, or yosys cannot read the RTL
#
#   cosim_add_program(TARGET)      a program with every command for all designs added so far
#   cosim_add_tests(TARGET         CTest tests of its designs, each with its kind as its label:
#     [HOSTILE clocks]             NAME.hostile, so many hostile clocks a shape (100000); NAME.proof,
#                                  unless it is UNPROVED
#     [RANDOM jobs]                NAME.random, so many random jobs a shape, of designs that have jobs
#     [MUTANTS n]                  NAME.mutants, so many small faults a shape, each found or proved to
#                                  be none; not of a design that is UNPROVED
#     [REGRESSIONS folder])        NAME.regression.FILE, for each FILE.stim in the folder: RTL and
#                                  model must not differ on it
#
# The parameters of a shape are those of the model's Params, in its order: int, or const char* for a
# text. Paths are relative to the folder that calls. RTL with a second clock, a falling edge, a latch, a
# combinational loop or a bidirectional port is refused, in a line that names the net.
include_guard(GLOBAL)
include(${CMAKE_CURRENT_LIST_DIR}/taken.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/../dut/rtl.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/../dut/shape.cmake)
set_property(GLOBAL PROPERTY COSIM_ROOT "${CMAKE_CURRENT_LIST_DIR}/../..")
include(${CMAKE_CURRENT_LIST_DIR}/../gtest/design_gtest.cmake)  # cosim_add_gtest(): tests by hand
include(${CMAKE_CURRENT_LIST_DIR}/../mutation/design_mutants.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/../coverage/design_cover.cmake)

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

# Many small files, most of whose time to compile is Verilator's header: compiled some classes at a
# time. Newer Verilators refuse two classes in one file, by a macro, for the sake of precompiled
# headers, which are not used here.
function(cosim_verilated_library target)
  add_library(${target} STATIC)
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX
    UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 40
    UNITY_BUILD_CODE_AFTER_INCLUDE "#undef VL_PCH_INCLUDED")
  target_compile_options(${target} PRIVATE -w)  # a user's flags are for a user's code
endfunction()

function(cosim_add_design NAME)
  if(NOT VERILATOR_ROOT)
    find_package(verilator REQUIRED HINTS $ENV{VERILATOR_ROOT} /usr/share/verilator)
  endif()
  cmake_parse_arguments(PARSE_ARGV 1 D "UNPROVED" "TOP;CLOCK" "SOURCES;INCLUDE_DIRS;DEFINES;MODEL;SHAPES")
  set(what "cosim_add_design(${NAME})")
  if(D_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "${what}: what is ${D_UNPARSED_ARGUMENTS}?")
  endif()
  if(NOT NAME MATCHES "^[A-Za-z][A-Za-z0-9_]*$")
    message(FATAL_ERROR "${what}: the name is not letters, digits and _, a letter first")
  endif()
  cosim_cpp_words(words)
  if(NAME IN_LIST words)
    message(FATAL_ERROR "${what}: the name is a word of C++")
  endif()
  cosim_taken_names(taken)
  if(";${taken};" MATCHES ";${NAME} ([^;]*)")
    message(FATAL_ERROR "${what}: the name is the harness's own, in ${CMAKE_MATCH_1}")
  endif()
  foreach(needed SOURCES MODEL)
    if(NOT D_${needed})
      message(FATAL_ERROR "${what}: needs ${needed}")
    endif()
  endforeach()
  set(TOP ${NAME})
  if(D_TOP)
    set(TOP ${D_TOP})
  endif()
  set(CLOCK clk)
  if(D_CLOCK)
    set(CLOCK ${D_CLOCK})
  endif()
  if(NOT D_SHAPES)
    set(D_SHAPES " ")
  endif()
  cosim_files(rtl "${what}: SOURCES" ${D_SOURCES})
  cosim_files(model "${what}: MODEL" ${D_MODEL})
  cosim_files(folders "${what}: INCLUDE_DIRS" ${D_INCLUDE_DIRS})

  set(MODEL_INCLUDES "")
  foreach(header IN LISTS model)
    file(STRINGS ${header} jobs REGEX "^COSIM_JOB[(]")
    if(jobs)
      set_property(GLOBAL APPEND PROPERTY COSIM_WITH_JOBS ${NAME})
    endif()
    string(APPEND MODEL_INCLUDES "#include \"${header}\"\n")
  endforeach()
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
  list(JOIN rtl "\" \"" for_yosys)
  list(JOIN options " " include_options)
  set(for_yosys "${include_options} \"${for_yosys}\"")
  list(JOIN rtl "\", \"" FILES)
  list(JOIN folders "\", \"" FOLDERS)
  list(JOIN D_DEFINES "\", \"" DEFINES)
  foreach(list FILES FOLDERS DEFINES)
    if(${list})
      set(${list} "\"${${list}}\"")
    endif()
  endforeach()

  get_property(root GLOBAL PROPERTY COSIM_ROOT)
  cosim_verilated_library(${NAME}_verilated)
  foreach(shape IN LISTS D_SHAPES)
    cosim_shape(shape "${what}" "${shape}")
    string(REGEX REPLACE "[ =]" "" ID "${NAME}${shape}")
    string(MAKE_C_IDENTIFIER "${ID}" ID)
    set(PREFIX V${ID})
    string(STRIP "${NAME} ${shape_title}" TITLE)
    set(PARAMETERS "${shape_values}")
    set(CONSTANTS "${shape_constants}")
    string(TOLOWER "${D_UNPROVED}" UNPROVED)  # true or false, for C++
    set(generics ${shape_generics})
    cosim_read_rtl(rtl_of "cosim_add_design(${TITLE})" ${TOP} ${CLOCK}
      ${CMAKE_CURRENT_BINARY_DIR}/rtl_${ID} FILES ${rtl} OPTIONS ${generics} ${options}
      YOSYS "read_verilog -sv ${for_yosys}; hierarchy -check -top ${TOP}${shape_chparams}")
    set(REGISTERS "${rtl_of_registers}")
    set(RESETS "${rtl_of_resets}")
    # Its whole hierarchy is open, for registers anywhere in it, for replays and for waves.
    verilate(${NAME}_verilated PREFIX ${PREFIX} TOP_MODULE ${TOP} SOURCES ${rtl}
      VERILATOR_ARGS ${generics} ${options} -Wno-fatal --x-initial unique --x-assign unique
                     --assert --vpi --public-flat-rw)
    configure_file(${root}/tb/package/named_bench_of.cpp.in
      ${CMAKE_CURRENT_BINARY_DIR}/bench_${ID}.cpp @ONLY)
    set_property(GLOBAL APPEND PROPERTY COSIM_BENCH_SOURCES
      ${CMAKE_CURRENT_BINARY_DIR}/bench_${ID}.cpp)
    set_property(GLOBAL APPEND PROPERTY COSIM_BENCHES ${ID})
    cosim_shape_mutants()
    cosim_shape_cover()
  endforeach()
  cosim_without_runtime(${NAME}_verilated)
  set_property(GLOBAL APPEND PROPERTY COSIM_VERILATED ${NAME}_verilated)
  set_property(GLOBAL APPEND PROPERTY COSIM_DESIGNS ${NAME})
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

function(cosim_add_program TARGET)
  get_property(root GLOBAL PROPERTY COSIM_ROOT)
  get_property(sources GLOBAL PROPERTY COSIM_BENCH_SOURCES)
  get_property(benches GLOBAL PROPERTY COSIM_BENCHES)
  get_property(verilated GLOBAL PROPERTY COSIM_VERILATED)
  if(NOT benches)
    message(FATAL_ERROR "cosim_add_program(${TARGET}): no design was added before it")
  endif()
  set(DECLARATIONS "")
  set(BENCHES "")
  set(MACHINES "")
  foreach(id IN LISTS benches)
    string(APPEND DECLARATIONS
      "void add_${id}(std::vector<std::unique_ptr<AnyBench>>& all);\nproof::BuiltMachine machine_${id}();\n")
    string(APPEND BENCHES "    add_benches(all, add_${id});\n")
    string(APPEND MACHINES "machine_${id}(), ")
  endforeach()
  get_property(on_demand GLOBAL PROPERTY COSIM_ON_DEMAND)
  list(JOIN on_demand "" ON_DEMAND)
  configure_file(${root}/tb/cli/program.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}.cpp @ONLY)
  add_executable(${TARGET} ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}.cpp ${sources})
  set_target_properties(${TARGET} PROPERTIES UNITY_BUILD_CODE_AFTER_INCLUDE "#undef VL_PCH_INCLUDED")
  foreach(library IN LISTS verilated)
    get_target_property(folders ${library} INCLUDE_DIRECTORIES)
    target_include_directories(${TARGET} SYSTEM PRIVATE ${folders})
  endforeach()
  target_compile_features(${TARGET} PRIVATE cxx_std_20)
  target_link_libraries(${TARGET} PRIVATE
    cosim::program cosim::prover cosim::stream cosim::dut cosim::harness ${verilated} cosim::runtime)
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
    message(FATAL_ERROR "${what}: what is ${T_UNPARSED_ARGUMENTS}?")
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
      set_tests_properties(${name}.proof PROPERTIES SKIP_REGULAR_EXPRESSION "needs (yosys|cvc5|z3)")
      if(T_MUTANTS)
        cosim_test(${name}.mutants mutants ${TARGET} mutate ${name} --mutants ${T_MUTANTS})
        # It builds, and has what the machine gives.
        set_tests_properties(${name}.mutants PROPERTIES RUN_SERIAL ON
          SKIP_REGULAR_EXPRESSION "needs (yosys|cvc5|z3)")
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
