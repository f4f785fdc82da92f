# The library of a design's classes whose whole hierarchy is open: tb/dut/open_dut.h.
include_guard(GLOBAL)

# Makes it of the target NAME_open, and sets OPEN_FILE, its path. To be called by cosim_add_design(), whose
# variables it uses, with what its RTL is. The name of the file follows from all that it is made of: what
# lies there under that name is right, and needs no build to be asked.
function(cosim_open_library made_of)
  cmake_path(NORMAL_PATH root)
  file(GLOB headers CONFIGURE_DEPENDS ${root}/tb/dut/*.h)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${headers})
  foreach(file IN LISTS headers ITEMS ${root}/tb/dut/ports.cmake ${root}/tb/package/named_open_of.cpp.in)
    file(SHA256 ${file} hash)
    string(APPEND made_of "${hash} ")
  endforeach()
  string(SHA256 hash "${made_of} ${verilator_VERSION} ${CMAKE_CXX_COMPILER} ${CMAKE_CXX_FLAGS}")
  string(SUBSTRING ${hash} 0 16 hash)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/open/${NAME})
  file(GLOB others ${folder}/*.so)
  list(FILTER others EXCLUDE REGEX "/${hash}[.]so$")
  if(others)
    file(REMOVE ${others})
  endif()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${NAME}_open.cpp)
  configure_file(${root}/tb/package/named_open_of.cpp.in ${source} @ONLY)
  target_sources(${NAME}_open PRIVATE ${source})
  set_target_properties(${NAME}_open PROPERTIES
    PREFIX "" SUFFIX .so OUTPUT_NAME ${hash} LIBRARY_OUTPUT_DIRECTORY ${folder})
  target_compile_features(${NAME}_open PRIVATE cxx_std_20)
  target_compile_options(${NAME}_open PRIVATE -O1)
  # Nothing is linked: Verilator's library, and all else, is in the program.
  target_include_directories(${NAME}_open SYSTEM PRIVATE
    $<TARGET_PROPERTY:cosim::dut,INTERFACE_INCLUDE_DIRECTORIES>)
  set(OPEN_FILE ${folder}/${hash}.so PARENT_SCOPE)
endfunction()
