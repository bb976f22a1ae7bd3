// error: microfacet{distribution, masking, Fresnel}: the
// of: smith_correlated{}, ggx{alpha{0.3f}}, schlick{0.04f}; ggx{alpha{0.3f}}, schlick{0.04f}, smith_correlated{}
// of: schlick{0.04f}, smith_correlated{}, ggx{alpha{0.3f}}; smith_correlated{}, schlick{0.04f}, ggx{alpha{0.3f}}
// of: ggx{alpha{0.3f}}, smith_correlated{}, ggx{alpha{0.3f}}; ggx{alpha{0.3f}}, ggx{alpha{0.3f}}, schlick{0.04f}
#include <lobe/lobe.hpp>

using namespace lobe;

auto shade(const glm::vec3& v, const glm::vec3& l) {
#ifdef LOBE_SHOULD_COMPILE
    const microfacet brdf{ggx{alpha{0.3f}}, smith_correlated{}, schlick{0.04f}};
#else
    const microfacet brdf{smith_correlated{}, ggx{alpha{0.3f}}, schlick{0.04f}};
#endif
    return brdf.f_cos(v, l);
}
