// error: the third is a callable of v.m in the scalar type of the distribution: schlick{0.04f} for ggx{alpha{0.3f}}
// of: schlick{0.04}; schlick{glm::dvec3(0.04)}; dielectric{1.5}; f82_tint{glm::dvec3(0.9), glm::dvec3(0.8)}
#include <lobe/lobe.hpp>

using namespace lobe;

// A double reflectance over float normals would round every cosine, or a float one every answer, without a word.
auto shade(const glm::vec3& v, const glm::vec3& l) {
#ifdef LOBE_SHOULD_COMPILE
    const auto F = schlick{0.04f};
#else
    const auto F = schlick{0.04};
#endif
    return microfacet{ggx{alpha{0.3f}}, smith_correlated{}, F}.f_cos(v, l);
}
