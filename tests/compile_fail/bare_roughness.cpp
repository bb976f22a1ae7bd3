// error: a bare number is no width: write alpha{0.3f}, or alpha<float>::from_roughness(r)
// of: ggx<float>{roughness}; beckmann<float>{roughness}; blinn_phong<float>{roughness}; phong<float>{roughness}
// of: student_t<float>{roughness, 2.0f}; gtr<float>{roughness, 1.0f}
#include <lobe/lobe.hpp>

using namespace lobe;

// The scalar type is given, so that no deduction guide is asked.
auto peak(float roughness) {
#ifdef LOBE_SHOULD_COMPILE
    const auto ndf = ggx<float>{alpha<float>::from_roughness(roughness)};
#else
    const auto ndf = ggx<float>{roughness};
#endif
    return ndf.D({0, 0, 1});
}
