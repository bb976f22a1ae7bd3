#pragma once

#include <lobe/core/cpp20.hpp>

#include <string_view>

// The one home of the version: CMake reads these three lines.
#define LOBE_VERSION_MAJOR 0
#define LOBE_VERSION_MINOR 1
#define LOBE_VERSION_PATCH 0

#define LOBE_STRING(x) #x
#define LOBE_DOTTED(x, y, z) LOBE_STRING(x) "." LOBE_STRING(y) "." LOBE_STRING(z)

namespace lobe {

/// "major.minor.patch"
inline constexpr std::string_view version = LOBE_DOTTED(LOBE_VERSION_MAJOR, LOBE_VERSION_MINOR, LOBE_VERSION_PATCH);

}  // namespace lobe

#undef LOBE_DOTTED
#undef LOBE_STRING
