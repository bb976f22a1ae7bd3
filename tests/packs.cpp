// The same templates on SIMD packs and on dual numbers.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/lobe.hpp>

#include <xsimd/xsimd.hpp>

using lobe::vec2;
using lobe::vec3;

namespace {

template <class Pack>
Pack load(const std::vector<typename Pack::value_type>& lanes) {
    return Pack::load_unaligned(lanes.data());
}

template <class Pack>
void compare_packs(typename Pack::value_type tolerance) {
    using T = typename Pack::value_type;
    random_numbers random(1);
    const auto make = [](const T& a) {
        return lobe::microfacet{lobe::ggx{lobe::alpha<T>(a)}, lobe::smith_correlated{},
                                lobe::schlick{vec3<T>{1, T(0.7), T(0.3)}}};
    };
    const lobe::microfacet wide{lobe::ggx{lobe::alpha<Pack>(Pack(T(0.3)))}, lobe::smith_correlated{},
                                lobe::schlick{vec3<Pack>{Pack(T(1)), Pack(T(0.7)), Pack(T(0.3))}}};
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<T> in[8];
        for (std::size_t lane = 0; lane < Pack::size; ++lane) {
            // some lights below the horizon
            const auto v = random.grazing_direction<T>(1e-3), l = random.direction<T>();
            const T values[8] = {v.x, v.y, v.z, l.x, l.y, l.z, static_cast<T>(random()), static_cast<T>(random())};
            for (int k = 0; k < 8; ++k) in[k].push_back(values[k]);
        }
        const vec3<Pack> v{load<Pack>(in[0]), load<Pack>(in[1]), load<Pack>(in[2])},
            l{load<Pack>(in[3]), load<Pack>(in[4]), load<Pack>(in[5])};
        const vec2<Pack> u{load<Pack>(in[6]), load<Pack>(in[7])};
        const auto e = wide.evaluate(v, l);
        const auto s = wide.sample(v, u);
        const lobe::frame<Pack> at(v);
        const auto back = at.to_world(at.to_local(l));
        const auto diffuse = lobe::lambert{vec3<Pack>{Pack(T(0.5)), Pack(T(0.6)), Pack(T(0.7))}}.evaluate(v, l);
        const auto weights =
            lobe::fdez_aguera{}(lobe::dfg_terms<Pack>{u.x * T(0.9), u.x * T(0.1)}, vec3<Pack>{u.y, u.y, u.y});
        for (std::size_t i = 0; i < Pack::size; ++i) {
            const vec3<T> vi{in[0][i], in[1][i], in[2][i]}, li{in[3][i], in[4][i], in[5][i]};
            const auto one = make(T(0.3)).evaluate(vi, li);
            CHECK(std::abs(e.f_cos.y.get(i) - one.f_cos.y) <= tolerance * one.f_cos.y);
            CHECK(std::abs(e.pdf.get(i) - one.pdf) <= tolerance * one.pdf);
            const auto sample = make(T(0.3)).sample(vi, {in[6][i], in[7][i]});
            CHECK(std::abs(s.l.x.get(i) - sample.l.x) <= tolerance * T(10));
            CHECK(std::abs(s.weight.z.get(i) - sample.weight.z) <= tolerance * T(100));
            CHECK(std::abs(back.x.get(i) - li.x) <= tolerance * T(10));
            CHECK(std::abs(diffuse.f_cos.y.get(i) - lobe::lambert{T(0.6)}.f_cos(vi, li)) <= tolerance);
            const auto metal = lobe::fdez_aguera{}(lobe::dfg_terms<T>{in[6][i] * T(0.9), in[6][i] * T(0.1)}, in[7][i]);
            CHECK(std::abs(weights.irradiance.x.get(i) - metal.irradiance) <= tolerance);
        }
    }
}

}  // namespace

TEST_CASE("a pack of floats or doubles gives what its lanes give", "[packs]") {
    compare_packs<xsimd::batch<float>>(2e-6f);
    compare_packs<xsimd::batch<double>>(4e-15);
}
