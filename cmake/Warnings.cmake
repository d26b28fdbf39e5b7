# Options for all our code, and for none of the headers of others.
add_library(ductus_options INTERFACE)
target_compile_options(ductus_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow $<$<BOOL:${DUCTUS_WERROR}>:-Werror>
  $<$<COMPILE_LANGUAGE:C>:-Wconversion -Wstrict-prototypes -Wmissing-prototypes>
  # The same bytes whatever the optimisation level and processor: no fused multiply-add behind our back.
  -ffp-contract=off -fno-math-errno -fvisibility=hidden)
target_compile_definitions(ductus_options INTERFACE _GNU_SOURCE)
if(DUCTUS_SANITIZE)
  target_compile_options(ductus_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                         -fno-omit-frame-pointer)
  target_link_options(ductus_options INTERFACE -fsanitize=address,undefined)
endif()
if(DUCTUS_COVERAGE)
  target_compile_options(ductus_options INTERFACE --coverage)
  target_link_options(ductus_options INTERFACE --coverage)
endif()
