// Writes shaders: any composition of lobe's branch-free formulas, recorded once, printed in any shading language.
// A room of its own beside the test kit; lobe.hpp does not include it.
#pragma once

#include <lobe/shader/cpp.hpp>
#include <lobe/shader/dfg.hpp>
#include <lobe/shader/function.hpp>
#include <lobe/shader/glsl.hpp>
#include <lobe/shader/hlsl.hpp>
#include <lobe/shader/msl.hpp>
#include <lobe/shader/print.hpp>
#include <lobe/shader/structs.hpp>
#include <lobe/shader/wgsl.hpp>
