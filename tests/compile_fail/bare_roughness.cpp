// A bare number is neither alpha nor roughness.
#include <lobe/lobe.hpp>

float peak(float roughness) {
#ifdef LOBE_SHOULD_COMPILE
    return lobe::ggx{lobe::alpha<float>::from_roughness(roughness)}.D({0, 0, 1});
#else
    return lobe::ggx<float>{roughness}.D({0, 0, 1});
#endif
}
