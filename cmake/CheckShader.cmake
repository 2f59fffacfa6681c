# A test as a script: inlines the includes of SHADER and has GLSLANG judge it.
execute_process(COMMAND ${PYTHON} ${EMBED} ${ROOT} ${SHADER} ${OUTPUT} shader --raw COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${GLSLANG} -S frag ${OUTPUT} COMMAND_ERROR_IS_FATAL ANY)
