// error: these normals have no projected area in closed form: write tabulated{...}, built once
// of: gtr{alpha{0.1f}, 1.0f}; phong{alpha{0.1f}}; abc{alpha{0.1f}, 1.5f}; sgd{alpha{0.1f}, 1.0f}
// of: exponential_power{alpha{0.1f}, 2.0f}; exponential_power{alpha_xy{0.1f, 0.2f}, 2.0f}
// of: mixture{gtr{alpha{0.1f}, 1.0f}, ggx{alpha{0.1f}}, 0.5f}
#include <lobe/lobe.hpp>

using namespace lobe;

auto coat() {
#ifdef LOBE_SHOULD_COMPILE
    const auto normals = tabulated{gtr{alpha{0.1f}, 1}};
#else
    const auto normals = gtr{alpha{0.1f}, 1.0f};
#endif
    return microfacet{normals, smith_correlated{}, schlick{0.04f}};
}
