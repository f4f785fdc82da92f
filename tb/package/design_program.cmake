# The program of all designs: their benches and what is proved of them as two libraries, the program with
# every command, and one that attacks their mutants. See design.cmake for cosim_add_program().
include_guard(GLOBAL)

# cosim_list(TYPE): sets DECLARATIONS and CALLS, which add the designs added so far to a list `all`.
function(cosim_list type)
  get_property(designs GLOBAL PROPERTY COSIM_DESIGNS)
  set(declarations "")
  set(calls "")
  foreach(name IN LISTS designs)
    string(APPEND declarations "void add_${name}(std::vector<${type}>& all);\n")
    string(APPEND calls "    add_${name}(all);\n")
  endforeach()
  set(DECLARATIONS "${declarations}" PARENT_SCOPE)
  set(CALLS "${calls}" PARENT_SCOPE)
endfunction()

function(cosim_add_program TARGET)
  get_property(designs GLOBAL PROPERTY COSIM_DESIGNS)
  if(NOT designs)
    message(FATAL_ERROR "cosim_add_program(${TARGET}): no design was added before it; call cosim_add_design() first")
  endif()
  cosim_program(${TARGET} ${ARGN})
endfunction()

# The same, be there a design or not. WITHOUT: which of the libraries stream and runtime_parts no design
# of the program needs; they are then not built for it. NAME: what it calls itself, where that is not TARGET.
function(cosim_program TARGET)
  cmake_parse_arguments(PARSE_ARGV 1 P "" "NAME" "SOURCES;LIBRARIES;REGISTER;THEOREMS;JOBS;WITHOUT")
  if(P_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "cosim_add_program(${TARGET}): unknown argument ${P_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT P_NAME)
    set(P_NAME ${TARGET})
  endif()
  get_property(root GLOBAL PROPERTY COSIM_ROOT)
  foreach(property SOURCES_OF_benches SOURCES_OF_machines VERILATED LIBRARIES ON_DEMAND EXPORTED)
    get_property(${property} GLOBAL PROPERTY COSIM_${property})
  endforeach()
  list(REMOVE_DUPLICATES LIBRARIES)

  # Two libraries, for programs of a user's own too: all benches, and what is proved of them.
  cosim_list("std::unique_ptr<AnyBench>")
  get_property(designs GLOBAL PROPERTY COSIM_DESIGNS)
  list(TRANSFORM designs REPLACE "(.+)" "add_\\1, " OUTPUT_VARIABLE ADDERS)
  list(JOIN ADDERS "" ADDERS)
  configure_file(${root}/tb/package/benches.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}_benches.cpp @ONLY)
  add_library(${TARGET}_benches STATIC ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}_benches.cpp ${SOURCES_OF_benches})
  target_include_directories(${TARGET}_benches PUBLIC ${CMAKE_CURRENT_BINARY_DIR})
  set(spare stream runtime_parts)
  list(REMOVE_ITEM spare ${P_WITHOUT})
  list(TRANSFORM spare PREPEND cosim::)
  target_link_libraries(${TARGET}_benches PUBLIC
    ${LIBRARIES} ${spare} cosim::dut cosim::harness ${VERILATED} cosim::runtime)
  # But for the loops over clocks, which say so themselves (COSIM_FLATTEN), nothing in it needs speed.
  target_compile_options(${TARGET}_benches PRIVATE $<$<CXX_COMPILER_ID:GNU>:-O1>)
  if(designs)  # what is loaded later takes Verilator's library from the program
    target_link_options(${TARGET}_benches INTERFACE -rdynamic)
  endif()
  cosim_list("proof::BuiltMachine")
  set(THEOREMS "")
  foreach(name IN LISTS P_THEOREMS)
    string(APPEND DECLARATIONS
      "}\nnamespace cosim::${name} {\nstd::vector<proof::Theorem> theorems();\n}\nnamespace cosim {\n")
    string(APPEND THEOREMS "${name}::theorems(), ")
  endforeach()
  configure_file(${root}/tb/package/machines.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}_machines.cpp @ONLY)
  # Built with what proves: an edited model is simulated sooner.
  add_library(${TARGET}_machines STATIC EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}_machines.cpp ${SOURCES_OF_machines})
  target_link_libraries(${TARGET}_machines PUBLIC ${P_LIBRARIES} ${LIBRARIES} cosim::prover PRIVATE cosim::once)
  if(EXPORTED)
    add_dependencies(${TARGET}_machines ${EXPORTED})
  endif()

  set(DECLARATIONS "")
  set(CALLS "")
  foreach(name IN LISTS P_REGISTER)
    string(APPEND DECLARATIONS "namespace cosim::${name} {\nvoid add_to(cli::Registry& registry);\n}\n")
    string(APPEND CALLS "    cosim::${name}::add_to,\n")
  endforeach()
  string(APPEND ON_DEMAND "    {BuiltOnDemand::Kind::full, \"\", \"${TARGET}_full\", \"${CMAKE_CURRENT_BINARY_DIR}\"},\n")
  string(APPEND ON_DEMAND "    {BuiltOnDemand::Kind::attacks, \"\", \"${TARGET}_mutants\", \"${CMAKE_CURRENT_BINARY_DIR}\"},\n")
  list(JOIN ON_DEMAND "" ON_DEMAND)
  configure_file(${root}/tb/package/program.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}.cpp @ONLY)
  add_library(${TARGET}_commands OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}.cpp ${P_SOURCES})
  target_link_libraries(${TARGET}_commands PUBLIC cosim::program ${P_LIBRARIES} PRIVATE cosim::once)
  if(designs)
    add_executable(${TARGET} $<TARGET_OBJECTS:${TARGET}_commands>)
    target_link_libraries(${TARGET} PRIVATE ${P_LIBRARIES}
      cosim::small cosim::program ${TARGET}_benches)
  endif()
  # Built when a command asks for it.
  add_executable(${TARGET}_full EXCLUDE_FROM_ALL $<TARGET_OBJECTS:${TARGET}_commands>)
  target_link_libraries(${TARGET}_full PRIVATE
    ${P_LIBRARIES} cosim::full cosim::program ${TARGET}_machines ${TARGET}_benches)
  # Another that is.
  set(JOBS_INCLUDES "")
  set(JOBS_DESIGNS)
  foreach(job IN LISTS P_JOBS)
    string(REGEX MATCH "^([^=]+)=(.+)$" _ "${job}")
    string(APPEND JOBS_INCLUDES "#include \"${CMAKE_MATCH_2}\"\n")
    get_property(space GLOBAL PROPERTY COSIM_NAMESPACE_OF_${CMAKE_MATCH_1})
    list(APPEND JOBS_DESIGNS "::${space}::Design")
  endforeach()
  list(JOIN JOBS_DESIGNS ", " JOBS_DESIGNS)
  configure_file(${root}/tb/package/mutants.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}_mutants.cpp @ONLY)
  add_executable(${TARGET}_mutants EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}_mutants.cpp)
  target_link_libraries(${TARGET}_mutants PRIVATE
    cosim::mutation ${TARGET}_machines ${TARGET}_benches cosim::cold)
  set_target_properties(${TARGET}_full ${TARGET}_mutants PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  foreach(target ${TARGET}_commands ${TARGET}_benches ${TARGET}_machines ${TARGET}_mutants)
    set_target_properties(${target} PROPERTIES
      UNITY_BUILD_CODE_AFTER_INCLUDE "#undef VL_PCH_INCLUDED")
  endforeach()
  set_target_properties(${TARGET}_benches ${TARGET}_machines PROPERTIES UNITY_BUILD OFF)
endfunction()
