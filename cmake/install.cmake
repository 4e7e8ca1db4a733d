# SPDX-License-Identifier: BSD-3-Clause
# What CMake installs: the files that Meson installs, and targets that other projects can export with their own.
if(NOT PW85_INSTALL)
  return()
endif()
set(_pw85_names pw85)
set(_pw85_on ${PW85_LIBRARY})
set(_pw85_kind "")
if(PW85_LIBRARY)
  set(_pw85_names ${PW85_LIBRARIES})
  get_target_property(_pw85_kind pw85 TYPE)
endif()

# The headers of parts that are left out.
set(_pw85_left_out "")
if(NOT PW85_SYSTEMS)
  list(APPEND _pw85_left_out PATTERN pw85_systems.h EXCLUDE PATTERN pw85_gpu.h EXCLUDE PATTERN systems.hpp EXCLUDE PATTERN systems EXCLUDE)
endif()
if(NOT PW85_SIMULATION)
  list(APPEND _pw85_left_out PATTERN pw85_simulation*.h EXCLUDE PATTERN simulation.hpp EXCLUDE PATTERN simulation EXCLUDE)
endif()
install(TARGETS pw85_headers EXPORT pw85HeadersTargets)
install(DIRECTORY include/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT pw85_devel
  FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp" ${_pw85_left_out})
install(FILES "${PROJECT_BINARY_DIR}/include/pw85/version.h" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/pw85" COMPONENT pw85_devel)
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/pw85" COMPONENT pw85_devel)
if(PW85_LIBRARY)
  install(TARGETS ${_pw85_names} EXPORT pw85Targets
    RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT pw85_runtime
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT pw85_runtime NAMELINK_COMPONENT pw85_devel
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT pw85_devel)
  install(FILES data/pw85_ref_data.h5 DESTINATION "${CMAKE_INSTALL_DATADIR}/pw85" COMPONENT pw85_devel)
endif()

# The packages for CMake, by the templates that Meson fills in, too. CMake writes the targets itself.
set(_pw85_packages "${CMAKE_INSTALL_LIBDIR}/cmake")
foreach(_pw85_set pw85HeadersTargets pw85Targets)
  if(PW85_LIBRARY OR _pw85_set STREQUAL "pw85HeadersTargets")
    install(EXPORT ${_pw85_set} NAMESPACE pw85:: DESTINATION "${_pw85_packages}/pw85" COMPONENT pw85_devel)
  endif()
endforeach()
function(pw85_switch variable)
  if(${ARGN})
    set(${variable} ON PARENT_SCOPE)
  else()
    set(${variable} OFF PARENT_SCOPE)
  endif()
endfunction()
set(VERSION ${PROJECT_VERSION})
set(VERSION_MAJOR ${PROJECT_VERSION_MAJOR})
pw85_switch(HAS_LIBRARY PW85_LIBRARY)
pw85_switch(HAS_SHARED _pw85_kind STREQUAL "SHARED_LIBRARY")
pw85_switch(HAS_STATIC _pw85_kind STREQUAL "STATIC_LIBRARY")
pw85_switch(HAS_GSL PW85_LIBRARY AND PW85_GSL AND GSL_FOUND)
pw85_switch(HAS_OPENMP PW85_LIBRARY AND PW85_OPENMP AND OpenMP_CXX_FOUND)
string(REPLACE ";" "," _pw85_parts "${PW85_PARTS}")
string(REPLACE ";" " " COMPONENTS "${PW85_PARTS}")
if(PW85_SYSTEMS)
  string(APPEND COMPONENTS " gpu")
endif()
string(REPLACE ";" " " LIBRARIES "${PW85_LIBRARIES}")
set(CXX_RUNTIME stdc++)
if("c++" IN_LIST CMAKE_CXX_IMPLICIT_LINK_LIBRARIES)
  set(CXX_RUNTIME c++)
endif()
foreach(NAME IN LISTS _pw85_names)
  set(_pw85_config cmake/pw85_partConfig.cmake.in)
  if(NAME STREQUAL "pw85")
    set(_pw85_config cmake/pw85Config.cmake.in)
  endif()
  configure_file(${_pw85_config} "cmake/${NAME}Config.cmake" @ONLY)
  configure_file(cmake/pw85ConfigVersion.cmake.in "cmake/${NAME}ConfigVersion.cmake" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/cmake/${NAME}Config.cmake" "${PROJECT_BINARY_DIR}/cmake/${NAME}ConfigVersion.cmake"
    DESTINATION "${_pw85_packages}/${NAME}" COMPONENT pw85_devel)
endforeach()

# The files for pkg-config. They name places relative to their own.
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}" OR IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
  message(STATUS "pw85: no files for pkg-config, which would not be relative to the prefix")
  return()
endif()
string(REGEX REPLACE "[^/]+" ".." PREFIX_FROM_HERE "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
# pw85_pkg_config(NAME DESCRIPTION LINE...)
function(pw85_pkg_config name description)
  set(libdir "")
  if(ARGN)
    set(libdir "libdir=\${prefix}/${CMAKE_INSTALL_LIBDIR}\n")
  endif()
  list(TRANSFORM ARGN APPEND "\n" OUTPUT_VARIABLE lines)
  string(REPLACE ";" "" lines "${lines}")
  file(WRITE "${PROJECT_BINARY_DIR}/cmake/${name}.pc" "prefix=\${pcfiledir}/${PREFIX_FROM_HERE}
includedir=\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}
${libdir}
Name: ${name}
Description: ${description}
Version: ${PROJECT_VERSION}
${lines}Cflags: -I\${includedir}
")
  install(FILES "${PROJECT_BINARY_DIR}/cmake/${name}.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT pw85_devel)
endfunction()
pw85_pkg_config(pw85-headers "Contact function of Perram and Wertheim for two ellipsoids: C++20 headers")
if(PW85_LIBRARY)
  set(_pw85_requires "")
  if(HAS_GSL)
    set(_pw85_requires "Requires.private: gsl")
  endif()
  pw85_pkg_config(pw85 "Contact function of Perram and Wertheim for two ellipsoids" ${_pw85_requires} "Libs: -L\${libdir} -lpw85"
    "Libs.private: -l${CXX_RUNTIME} -lm -Wl,--exclude-libs,libpw85.a ${OpenMP_CXX_FLAGS}" "parts=${_pw85_parts}")
  if(PW85_SYSTEMS)
    pw85_pkg_config(pw85_gpu "Contact function of Perram and Wertheim on NVIDIA GPUs" "Requires: pw85" "Libs: -L\${libdir} -lpw85_gpu"
      "Libs.private: -Wl,--exclude-libs,libpw85_gpu.a ${OpenMP_CXX_FLAGS}")
  endif()
  pw85_pkg_config(pw85_legacy "Superseded variants of the contact function of Perram and Wertheim" "Requires: pw85"
    "Libs: -L\${libdir} -lpw85_legacy" "Libs.private: -Wl,--exclude-libs,libpw85_legacy.a")
endif()
