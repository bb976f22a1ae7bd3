#include "element.hpp"

#include <lobe/fresnel/f82_tint.hpp>
#include <lobe/fresnel/ior.hpp>
#include <lobe/fresnel/materials.hpp>

#include <glm/common.hpp>

#include <cmath>
#include <random>

namespace {

class random_numbers {
public:
    double operator()() { return static_cast<double>(engine() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * (*this)(); }
    double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

private:
    std::mt19937_64 engine{20240229};
};

using direction = std::array<double, 3>;

direction at(double cosine, double azimuth) {
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

/// The inverse CDF of GGX: normals lie where the distribution has them, near its peak.
direction ggx_normal(double ax, double ay, double u, double azimuth) {
    const direction m{ax * std::sqrt(u) * std::cos(azimuth), ay * std::sqrt(u) * std::sin(azimuth), std::sqrt(1 - u)};
    const double length = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    return {m[0] / length, m[1] / length, m[2] / length};
}

template <class V>
void store(const V& rgb, parameters::rgb& out, std::size_t i) {
    for (int k = 0; k < 3; ++k) out[static_cast<std::size_t>(k)][i] = static_cast<float>(rgb[k]);
}

void store(const direction& w, stream<float>& x, stream<float>& y, stream<float>& z, std::size_t i) {
    x[i] = static_cast<float>(w[0]);
    y[i] = static_cast<float>(w[1]);
    z[i] = static_cast<float>(w[2]);
}

void make_parameters(inputs& in, random_numbers& random) {
    using namespace lobe::materials;
    const lobe::conductor<lobe::vec3<double>> metals[] = {gold<double>(), silver<double>(), copper<double>(),
                                                          iron<double>(), aluminium<double>()};
    parameters& p = in.more;
    for (std::size_t i = 0; i < count; ++i) {
        p.fraction[i] = static_cast<float>(random()) * 0.999999f;
        p.roughness[i] = std::sqrt(in.a[i]);
        p.length[i] = static_cast<float>(random.between(0.8, 1));
        p.eta[i] = static_cast<float>(random.between(1.3, 2.5));
        p.f0[i] = lobe::f0_from_ior(p.eta[i]);
        const double c = in.v_m[i], n = p.eta[i], K = std::sqrt(n * n - 1 + c * c) - c;
        store(lobe::vec3<double>{-(in.vx[i] + K * in.mx[i]) / n, -(in.vy[i] + K * in.my[i]) / n,
                                 -(in.vz[i] + K * in.mz[i]) / n},
              p.refracted, i);
        for (stream<float>& slope : p.slopes) slope[i] = static_cast<float>(random.between(-0.2, 0.2));

        const auto& metal = metals[i % 5];
        const lobe::vec3<double> at_82 = metal(1.0 / 7), of_schlick = lobe::schlick{metal.F0()}(1.0 / 7);
        store(metal.index(), p.metal_eta, i);
        store(metal.extinction(), p.metal_k, i);
        store(metal.F0(), p.metal_F0, i);
        store(glm::min(at_82 / of_schlick, lobe::vec3<double>(1.0)), p.metal_tint, i);
    }
}

}  // namespace

void set_average_albedos(inputs& in) {
    const lobe::gauss_legendre<double> rule(32);
    for (std::size_t i = 0; i < count; ++i) {
        lobe::vec3<double> average(0.0);
        const lobe::vec3<double> F0{in.r[i], in.g[i], in.b[i]};
        for (std::size_t k = 0; k < rule.x.size(); ++k) {
            const double mu = rule.x[k];
            const auto t = in.built->dfg(static_cast<float>(mu), lobe::alpha{in.a[i]});
            average += (F0 * double(t.scale) + double(t.bias)) * (2 * rule.w[k] * mu);
        }
        store(average, in.more.E_avg, i);
    }
}

inputs make_inputs(set which) {
    const bool extreme = which == set::extreme;
    const double turn = 2 * 3.14159265358979323846;
    random_numbers random;
    inputs in;
    in.points = extreme ? ~std::uint32_t{0} : static_cast<std::uint32_t>(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double a = extreme ? 1e-4 : random.log_between(1e-3, 1);
        direction v, m, l;
        double v_m;
        do {  // a normal that v sees, and whose reflection is above the horizon
            v = at(random.between(0.01, 1), turn * random());
            m = ggx_normal(a, a, random(), turn * random());
            v_m = v[0] * m[0] + v[1] * m[1] + v[2] * m[2];
            for (std::size_t k = 0; k < 3; ++k) l[k] = 2 * v_m * m[k] - v[k];
        } while (v_m <= random() || l[2] < 0.01);
        store(v, in.vx, in.vy, in.vz, i);
        store(l, in.lx, in.ly, in.lz, i);
        store(m, in.mx, in.my, in.mz, i);
        in.v_m[i] = static_cast<float>(v_m);
        in.a[i] = static_cast<float>(a);

        const double ax = extreme ? 1e-4 : random.log_between(1e-3, 1),
                     ay = random.log_between(extreme ? 1e-4 : 1e-3, 1);
        store(ggx_normal(ax, ay, random(), turn * random()), in.nx, in.ny, in.nz, i);
        in.ax[i] = static_cast<float>(ax);
        in.ay[i] = static_cast<float>(ay);

        in.u1[i] = static_cast<float>(random()) * 0.999999f;
        in.u2[i] = static_cast<float>(random()) * 0.999999f;
        in.turn[i] =
            static_cast<float>(extreme ? std::floor(4 * random()) / 4 + random.log_between(1e-6, 1e-3) : random());
        in.r[i] = static_cast<float>(random.between(0.02, 1));
        in.g[i] = static_cast<float>(random.between(0.02, 1));
        in.b[i] = static_cast<float>(random.between(0.02, 1));
        // many low bits set
        in.index[i] = static_cast<std::uint32_t>(extreme ? 0xffffffff - ((i + 1) << 22) % 0xffffffff : i);
    }
    make_parameters(in, random);
    return in;
}
