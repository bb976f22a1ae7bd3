// The split-sum terms by integration: calls of microseconds, which a loop around them does not change.
#include "kernel.hpp"
#include "textbook.hpp"
#include "truth.hpp"

namespace {

template <auto Terms>
std::uint32_t one_at_a_time(const inputs& in, std::uint32_t zero) {
    std::uint32_t last = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t k = i + (last & zero);
        last = static_cast<std::uint32_t>(Terms(in.vz[k], in.a[k]).x * 1e6f);
    }
    return last;
}
template <auto Terms>
void loop(const inputs& in, float* out) {
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec2 t = Terms(in.vz[i], in.a[i]);
        out[i] = t.x;
        out[stride + i] = t.y;
    }
}

template <int Order>
glm::vec2 exact(float mu, float a) {
    const auto t = lobe::dfg_exact(lobe::smith_correlated{}, mu, lobe::alpha{a}, {.order = Order});
    return {t.scale, t.bias};
}

glm::vec2 monte_carlo(float mu, float a) { return textbook::integrate_brdf(mu, a, 1024); }

std::uint32_t lobe_bake(const inputs&, std::uint32_t) {
    static_assert(32 * 32 == count);
    const auto table = lobe::bake_dfg<float>(lobe::smith_correlated{}, {.size = 32});
    return static_cast<std::uint32_t>(table(0.5f, lobe::alpha{0.5f}).scale * 1e6f);
}
std::uint32_t bake_textbook(const inputs&, std::uint32_t) { return static_cast<std::uint32_t>(textbook::bake(32, 1024).scale[0] * 1e6f); }

}  // namespace

std::vector<kernel> quadrature_kernels() {
    return {
        {"dfg_exact 16", 2, one_at_a_time<exact<16>>, loop<exact<16>>, false},
        {"dfg_exact 32", 2, one_at_a_time<exact<32>>, loop<exact<32>>, false},
        {"Monte Carlo", 2, one_at_a_time<monte_carlo>, loop<monte_carlo>, false},
        {"lobe bake", 0, lobe_bake, nullptr, false},
        {"textbook bake", 0, bake_textbook, nullptr, false},
    };
}

textbook_table textbook_bake(int size, std::uint32_t samples) { return textbook::bake(size, samples); }

truth::terms truth::dfg(const inputs& in, std::size_t i) {
    const auto t = lobe::dfg_exact(lobe::smith_correlated{}, double(in.vz[i]), lobe::alpha{double(in.a[i])}, {.order = 128});
    return {t.scale, t.bias};
}
