// error: deleted
// says: convert the vectors: vec3<T>(v)
// of: brdf.f_cos(v, l); brdf.f(v, l); glm::vec3(1) * brdf.evaluate(v, l).f_cos; glm::vec3(brdf.pdf(v, l))
// of: brdf.sample(v, glm::dvec2(0.5)).weight; brdf.f_cos(v, glm::vec3(l))
#include <lobe/lobe.hpp>

// GLM would convert the vectors of a double renderer to float without a word.
glm::vec3 shade(const glm::dvec3& v, const glm::dvec3& l) {
    const lobe::microfacet brdf{lobe::ggx{lobe::alpha{0.3f}}, lobe::smith_correlated{}, lobe::schlick{glm::vec3(0.5f)}};
#ifdef LOBE_SHOULD_COMPILE
    return brdf.f_cos(glm::vec3(v), glm::vec3(l));
#else
    return brdf.f_cos(v, l);
#endif
}
