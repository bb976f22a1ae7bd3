// A float reflectance under a double distribution would round every answer to float without a word.
#include <lobe/lobe.hpp>

double shade(const glm::dvec3& v, const glm::dvec3& l) {
#ifdef LOBE_SHOULD_COMPILE
    const lobe::schlick F{0.04};
#else
    const lobe::schlick F{0.04f};
#endif
    return lobe::microfacet{lobe::ggx{lobe::alpha{0.3}}, lobe::smith_correlated{}, F}.f_cos(v, l);
}
