# The steps a stranger takes: install, configure, build, run. WORK is made anew, so that nothing of an earlier
# installation can help.

function(step)
    execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK}")
step("${CMAKE_COMMAND}" --install "${BUILD}" --config "${CONFIG}" --component core --prefix "${WORK}/prefix")
step("${CMAKE_COMMAND}" -S "${STRANGER}" -B "${WORK}/build" -G "${GENERATOR}"
    "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_BUILD_TYPE=${CONFIG}" "-DCMAKE_PREFIX_PATH=${WORK}/prefix"
    "-DETENDUE_WANTED=${VERSION}"
)
step("${CMAKE_COMMAND}" --build "${WORK}/build" --config "${CONFIG}")
step("${WORK}/build/stranger")
