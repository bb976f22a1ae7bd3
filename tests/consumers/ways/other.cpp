#include "other.hpp"

float other_unit(const glm::vec3& v, const glm::vec3& l) {
    return lobe::microfacet{lobe::ggx{lobe::alpha{0.3f}}, lobe::smith_correlated{}, lobe::schlick{0.04f}}.f_cos(v, l);
}
