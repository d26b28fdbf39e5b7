# Everything comes from Debian; script/bootstrap installs it.
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(LIBXML2 REQUIRED IMPORTED_TARGET libxml-2.0)
pkg_check_modules(LIBMYPAINT REQUIRED IMPORTED_TARGET libmypaint>=1.6)
pkg_check_modules(JSONC REQUIRED IMPORTED_TARGET json-c)
pkg_check_modules(ZLIB REQUIRED IMPORTED_TARGET zlib)
pkg_check_modules(LAPACKE REQUIRED IMPORTED_TARGET lapacke)
# FLANN's pkg-config file drags in HDF5 and MPI, which its C library does not need.
find_library(FLANN_LIBRARY flann REQUIRED)
find_path(FLANN_INCLUDE_DIR flann/flann.h REQUIRED)
add_library(ductus_flann INTERFACE)
target_link_libraries(ductus_flann INTERFACE ${FLANN_LIBRARY})
target_include_directories(ductus_flann SYSTEM INTERFACE ${FLANN_INCLUDE_DIR})
# GEOS through its C interface, which is the stable one.
find_library(GEOS_LIBRARY geos_c REQUIRED)
find_path(GEOS_INCLUDE_DIR geos_c.h REQUIRED)
add_library(ductus_geos INTERFACE)
target_link_libraries(ductus_geos INTERFACE ${GEOS_LIBRARY})
target_include_directories(ductus_geos SYSTEM INTERFACE ${GEOS_INCLUDE_DIR})

# Debian's own Python: the tests of the plug-ins need Debian's modules, and a python3 first in PATH may lack them.
if(NOT DEFINED Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python3 REQUIRED COMPONENTS Interpreter)
