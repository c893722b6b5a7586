# find_package(microwarp) gives the target microwarp::microwarp: the headers and the library.
get_filename_component(_microwarp_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(NOT TARGET microwarp::microwarp)
  add_library(microwarp::microwarp STATIC IMPORTED)
  set_target_properties(microwarp::microwarp PROPERTIES
    IMPORTED_LOCATION "${_microwarp_prefix}/lib/libmicrowarp.a"
    INTERFACE_INCLUDE_DIRECTORIES "${_microwarp_prefix}/include"
    # Each function is a section of its own; the linker drops those that nothing calls.
    INTERFACE_LINK_OPTIONS "$<$<PLATFORM_ID:Linux,Generic>:LINKER:--gc-sections>")
endif()
unset(_microwarp_prefix)
