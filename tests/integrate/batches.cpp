// The loops of docs/integrate.md's batches: tests/settings/vectorised.sh asks the compiler whether they vectorise.
#include "batches.hpp"

void metal(const glm::vec3& F0, float a, batches::batch& hits);
void dielectric(batches::batch& hits);

void metal(const glm::vec3& F0, float a, batches::batch& hits) {
    batches::shade(lobe::microfacet{lobe::ggx{lobe::alpha{a}}, lobe::smith_correlated{}, lobe::schlick{F0}}, hits);
}
void dielectric(batches::batch& hits) { batches::shade_textured(hits); }
