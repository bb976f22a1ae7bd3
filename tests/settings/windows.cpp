// After <windows.h>, whole: without WIN32_LEAN_AND_MEAN, which keeps out rpcndr.h with its `small` and `interface`.
// Without NOMINMAX, too.
#include <windows.h>

#include "everything.hpp"

#include <lobe/testkit.hpp>

int main() {
    const everything::input<float> in{{0.6f, 0, 0.8f}, {0.48f, -0.6f, 0.64f}, {0.3f, 0.7f}, 0.3f, 0.4f};
    int finite = 0;
    everything::for_each(in, [&](const char*, float value) { finite += std::isfinite(value); });
    const lobe::microfacet gold{lobe::ggx{in.a()}, lobe::smith_correlated{}, lobe::schlick{in.color()}};
    return (lobe::testkit::verify)(gold).passed() && finite > 0 ? 0 : 1;
}
