// error: a bare number is no width: write alpha{0.3f}, or alpha<float>::from_roughness(r)
// of: ggx{0.3f}; ggx{0.3}; ggx{1}; ggx{1u}; ggx{0.3L}; beckmann{0.3f}; beckmann{1}; beckmann_walter{0.3}
// of: blinn_phong{0.3f}; blinn_phong{1}; phong{0.3f}; phong{1}; sggx{0.3f}; sggx{1}; hyper_cauchy{0.3, 3}
// of: student_t{0.3f, 2.0f}; student_t{0.3f, 2.0}; student_t{1, 2}; exponential_power{0.3f, 2.0f}; gtr{0.3f, 1.0f}
// of: gtr{0.3, 1}; abc{0.3f, 1.5f}; abc{1, 2}; sgd{0.3, 1.0}; tabulated{gtr{0.3f, 1.0f}}
#include <lobe/lobe.hpp>

using namespace lobe;

auto peak() {
#ifdef LOBE_SHOULD_COMPILE
    const auto ndf = ggx{alpha<float>::from_roughness(0.3f)};
#else
    const auto ndf = ggx{0.3f};
#endif
    return ndf.D({0, 0, 1});
}
