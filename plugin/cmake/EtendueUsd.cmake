# Etendue::usd: OpenUSD with its imaging libraries and their headers, when there is such an SDK. Found through, in this
# order:
#   USD_LIBRARY, USD_INCLUDE_DIR   one monolithic library (libusd_ms.so) and the headers that belong to it
#   find_package(pxr CONFIG)       an installed OpenUSD; pxr_DIR or CMAKE_PREFIX_PATH says where

set(USD_LIBRARY "" CACHE FILEPATH "A monolithic OpenUSD library; with it USD_INCLUDE_DIR")
set(USD_INCLUDE_DIR "" CACHE PATH "The headers that belong to USD_LIBRARY: the directory that has pxr/pxr.h")

if(USD_LIBRARY OR USD_INCLUDE_DIR)
    if(NOT EXISTS "${USD_LIBRARY}" OR NOT EXISTS "${USD_INCLUDE_DIR}/pxr/pxr.h")
        message(FATAL_ERROR "USD_LIBRARY (${USD_LIBRARY}) must be a library and "
            "USD_INCLUDE_DIR (${USD_INCLUDE_DIR}) must have pxr/pxr.h")
    endif()
    add_library(etendue_usd INTERFACE)
    target_include_directories(etendue_usd SYSTEM INTERFACE "${USD_INCLUDE_DIR}")
    target_link_libraries(etendue_usd INTERFACE "${USD_LIBRARY}")
    # A USD with Python has other layouts of its own types, and its headers include Python's.
    file(STRINGS "${USD_INCLUDE_DIR}/pxr/pxr.h" with_python REGEX "^ *# *define +PXR_PYTHON_SUPPORT_ENABLED")
    if(with_python)
        find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
        target_include_directories(etendue_usd SYSTEM INTERFACE ${Python3_INCLUDE_DIRS})
    endif()
    # The library was linked where its own dependencies are; here they need not be.
    target_link_options(etendue_usd INTERFACE LINKER:--allow-shlib-undefined)
    add_library(Etendue::usd ALIAS etendue_usd)
else()
    find_package(pxr CONFIG QUIET)
    if(pxr_FOUND)
        add_library(etendue_usd INTERFACE)
        target_include_directories(etendue_usd SYSTEM INTERFACE "${PXR_INCLUDE_DIRS}")
        if(TARGET usd_ms)
            target_link_libraries(etendue_usd INTERFACE usd_ms)
        else()
            target_link_libraries(etendue_usd INTERFACE hd pxOsd cameraUtil usdLux sdf ar)
        endif()
        add_library(Etendue::usd ALIAS etendue_usd)
    endif()
endif()

# A library that a USD program loads.
function(etendue_add_usd_module name)
    add_library(${name} MODULE ${ARGN})
    etendue_set_compile_options(${name})
    set_target_properties(${name} PROPERTIES PREFIX "")
    target_compile_definitions(${name} PRIVATE
        MFB_PACKAGE_NAME=${name} MFB_ALT_PACKAGE_NAME=${name} MFB_PACKAGE_MODULE=${name}
    )
    # USD's own headers use what they deprecate.
    target_compile_options(${name} PRIVATE -Wno-deprecated)
    if(ETENDUE_SANITIZE MATCHES "thread")
        # The sanitizer does not know the fences of VtArray, GCC says.
        target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-tsan>)
    endif()
    target_link_libraries(${name} PRIVATE Etendue::usd)
endfunction()
