# cmake -DPROGRAM=FILE -DABOUT=LINE -P man.cmake: writes beside the program its page for man, of what
# its --help prints, NAME.1.gz, and its completion for bash, NAME.bash.
cmake_path(GET PROGRAM FILENAME name)

# said(VARIABLE WORD...): what the program prints.
function(said variable)
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()
# As it stands, for troff.
function(verbatim variable text)
  string(REPLACE "\\" "\\e" text "${text}")
  string(REPLACE "-" "\\-" text "${text}")
  string(REGEX REPLACE "(^|\n)([.'])" "\\1\\\\&\\2" text "${text}")
  set(${variable} ".nf\n${text}.fi\n" PARENT_SCOPE)
endfunction()

said(version --version)
string(STRIP "${version}" version)
said(help --help)
verbatim(help "${help}")
said(new new --help)
verbatim(new "${new}")
string(TOUPPER ${name} NAME)
file(WRITE ${PROGRAM}.1 ".TH ${NAME} 1 \"\" \"${version}\"
.SH NAME
${name} \\- ${ABOUT}
.SH DESCRIPTION
A design in Verilog runs beside its golden model in C++, and every register and output is compared on
every clock. This program makes a project for a design; the project builds a program of its own, whose
commands its \\-\\-help names.
.SH OPTIONS
${help}.SH MAKING A PROJECT
${new}")
execute_process(COMMAND gzip -9nf ${PROGRAM}.1 COMMAND_ERROR_IS_FATAL ANY)
said(completion --completion)
file(WRITE ${PROGRAM}.bash "${completion}")
