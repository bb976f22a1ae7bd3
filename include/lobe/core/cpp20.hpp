// Included first by every header: one error instead of hundreds where the compiler is told an older standard.
#pragma once

#if __cplusplus <= 201703L && (!defined(_MSVC_LANG) || _MSVC_LANG <= 201703L)
#error lobe needs C++20. Compile with -std=c++20 (MSVC: /std:c++20); in CMake, link lobe::lobe, which asks for it.
#include <lobe/this_is_not_cpp20>  // no such file: the compiler stops here
#endif
