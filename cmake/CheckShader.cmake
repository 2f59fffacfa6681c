# A test as a script: inlines the includes of SHADER and has GLSLANG judge it, by its ending as vertex or fragment shader; DEFINES are -DNAME=VALUE.
execute_process(COMMAND ${PYTHON} ${EMBED} ${ROOT} ${SHADER} ${OUTPUT} shader --raw COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${GLSLANG} -l ${DEFINES} ${OUTPUT} COMMAND_ERROR_IS_FATAL ANY)
