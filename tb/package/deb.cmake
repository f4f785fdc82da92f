# `cpack` in the build folder: a Debian package of what `cmake --install` installs. Its libraries are
# compiled for the fmt and the Verilator of this machine.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME cosim)
set(CPACK_PACKAGE_CONTACT "cosim maintainers <maintainers@cosim.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES OFF)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # of its program
string(REGEX MATCH "^[0-9]+" fmt_major "${fmt_VERSION}")
math(EXPR fmt_next "${fmt_major} + 1")
string(REGEX MATCH "^[0-9]+\\.[0-9]+" verilator_minor "${verilator_VERSION}")
set(CPACK_DEBIAN_PACKAGE_DEPENDS
  "cmake (>= 3.25)" "ninja-build" "g++ | clang" "libcadical-dev" "libcli11-dev"
  "nlohmann-json3-dev" "zlib1g-dev"
  "libfmt-dev (>= ${fmt_major})" "libfmt-dev (<< ${fmt_next})"
  "verilator (>= ${verilator_minor})" "verilator (<< ${verilator_minor}.~)")
list(JOIN CPACK_DEBIAN_PACKAGE_DEPENDS ", " CPACK_DEBIAN_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "yosys, iverilog, make, z3, libgtest-dev")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "gtkwave, iverilog, lcov")
include(CPack)
