#include "other.hpp"

int main() {
    const lobe::microfacet brdf{lobe::ggx{lobe::alpha{0.3f}}, lobe::smith_correlated{}, lobe::schlick{0.04f}};
    const glm::vec3 v{0.6f, 0.0f, 0.8f}, l{0.0f, 0.6f, 0.8f};
    const float difference = brdf.f_cos(v, l) - other_unit(v, l);  // of rounding, where units are optimised apart
    return difference < 1e-6f && difference > -1e-6f ? 0 : 1;
}
