# Finds what the core is built from and declares one imported target for each: Etendue::embree, Etendue::tbb,
# Etendue::openimageio, Etendue::opencolorio.
#
# The libraries' own CMake packages are not used: OpenImageIO's on Debian 12 also insists on its command-line tools, on
# the Python bindings of Imath and on the headers of OpenCV, OpenColorIO's is not where CMake looks. What we need is a
# header and a library each.

include(FindPackageHandleStandardArgs)

macro(etendue_find_dependency name header)
    find_path(Etendue_${name}_INCLUDE_DIR "${header}")
    set(_etendue_required Etendue_${name}_INCLUDE_DIR)
    set(_etendue_libraries "")
    foreach(_etendue_library ${ARGN})
        find_library(Etendue_${name}_${_etendue_library}_LIBRARY "${_etendue_library}")
        mark_as_advanced(Etendue_${name}_${_etendue_library}_LIBRARY)
        list(APPEND _etendue_required Etendue_${name}_${_etendue_library}_LIBRARY)
        list(APPEND _etendue_libraries "${Etendue_${name}_${_etendue_library}_LIBRARY}")
    endforeach()
    mark_as_advanced(Etendue_${name}_INCLUDE_DIR)
    find_package_handle_standard_args(Etendue_${name} REQUIRED_VARS ${_etendue_required} NAME_MISMATCHED)
    if(NOT Etendue_${name}_FOUND)
        message(FATAL_ERROR "Etendue needs ${name}: no ${header}, or no library (${ARGN})")
    endif()
    if(NOT TARGET Etendue::${name})
        add_library(Etendue::${name} INTERFACE IMPORTED)
        target_include_directories(Etendue::${name} SYSTEM INTERFACE "${Etendue_${name}_INCLUDE_DIR}")
        target_link_libraries(Etendue::${name} INTERFACE ${_etendue_libraries})
    endif()
endmacro()

etendue_find_dependency(embree embree3/rtcore.h embree3)
etendue_find_dependency(tbb oneapi/tbb/version.h tbb)
etendue_find_dependency(openimageio OpenImageIO/imageio.h OpenImageIO OpenImageIO_Util)
etendue_find_dependency(opencolorio OpenColorIO/OpenColorIO.h OpenColorIO)
