// Everything and the test kit, in float and double, for the compiler to warn of.
#include "everything.hpp"

#include <lobe/testkit.hpp>

#include <iostream>

namespace {

template <class T>
void all_of() {
    const everything::input<T> in{
        {T(0.6f), T(0), T(0.8f)}, {T(0.48f), T(-0.6f), T(0.64f)}, {T(0.3f), T(0.7f)}, T(0.3f), T(0.4f)};
    everything::for_each(in, [](const char* name, T value) { std::cout << name << ' ' << value << '\n'; });
    const lobe::ggx normals{lobe::alpha<T>(in.width)};
    const lobe::microfacet gold{normals, lobe::smith_correlated{}, lobe::schlick{lobe::vec3<T>(in.color())}};
    const lobe::microfacet grey{normals, lobe::smith_correlated{}, lobe::schlick{in.x}};
    std::vector<lobe::vec2<T>> points;
    for (std::uint32_t i = 0; i < 64; ++i) points.push_back(lobe::hammersley<T>(i, 64u));
    std::cout << lobe::testkit::verify(gold) << lobe::testkit::verify(grey)
              << lobe::testkit::verify_distribution(normals) << lobe::testkit::verify_fresnel(lobe::schlick{in.x})
              << lobe::testkit::verify_sequence(points);
}

}  // namespace

int main() {
    all_of<float>();
    all_of<double>();
}
