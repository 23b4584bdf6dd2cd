# The language, the warnings and the sanitizers of our own targets.

function(etendue_set_compile_options target)
    target_compile_features(${target} PUBLIC cxx_std_20)
    set_target_properties(${target} PROPERTIES
        CXX_EXTENSIONS OFF
        CXX_VISIBILITY_PRESET hidden
        VISIBILITY_INLINES_HIDDEN ON
        POSITION_INDEPENDENT_CODE ON
    )
    target_compile_options(${target} PRIVATE
        -Wall -Wextra -Wpedantic -Wconversion -Wnon-virtual-dtor -Woverloaded-virtual
        -Wmissing-declarations -Wimplicit-fallthrough
        $<$<CXX_COMPILER_ID:GNU>:-Wduplicated-cond -Wlogical-op>
        # GCC's full -Wshadow also reports enumerators of scoped enumerations.
        $<IF:$<CXX_COMPILER_ID:GNU>,-Wshadow=local,-Wshadow>
        # GCC 12 sees overlapping copies in std::string's own operator+.
        $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
        $<$<BOOL:${ETENDUE_WERROR}>:-Werror>
    )
    if(ETENDUE_SANITIZE)
        # GCC's data-flow warnings go wrong on instrumented code; the uninstrumented builds keep them.
        target_compile_options(${target} PRIVATE
            -fsanitize=${ETENDUE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
            $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-stringop-overflow -Wno-array-bounds>
        )
        target_link_options(${target} PUBLIC -fsanitize=${ETENDUE_SANITIZE})
    endif()
endfunction()
