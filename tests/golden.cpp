// The golden values of docs/reference, read as anybody may read them, against lobe in float and double.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/lobe.hpp>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct golden {
    std::string normals, quantity;
    double ax, ay;
    glm::dvec3 v, l;
    double value, condition;
};

std::vector<golden> golden_values() {
    std::ifstream file(std::string(LOBE_REFERENCE_DIR) + "/../../docs/reference/golden.csv");
    std::vector<golden> out;
    std::string line;
    std::getline(file, line), std::getline(file, line);
    REQUIRE(line == "normals,alpha_x,alpha_y,quantity,v_x,v_y,v_z,l_x,l_y,l_z,value,condition");
    while (std::getline(file, line)) {
        std::vector<std::string> cell;
        std::istringstream cells(line + ',');
        for (std::string c; std::getline(cells, c, ',');) cell.push_back(c);
        REQUIRE(cell.size() == 12);
        const auto x = [&](std::size_t i) { return std::strtod(cell[i].c_str(), nullptr); };
        out.push_back({cell[0], cell[3], x(1), x(2), {x(4), x(5), x(6)}, {x(7), x(8), x(9)}, x(10), x(11)});
    }
    return out;
}

template <class T>
using V = glm::vec<3, T>;

template <class T, class N>
T of_normals(const golden& g, const N& ndf) {
    const V<T> v(g.v), l(g.l);
    const lobe::microfacet brdf{ndf, lobe::smith_correlated{}, lobe::schlick{T(0.04)}};
    if (g.quantity == "D") return ndf.D(v);
    if (g.quantity == "Lambda") return ndf.lambda(v);
    if (g.quantity == "G1") return T(1) / (T(1) + ndf.lambda(v));
    if (g.quantity == "G2") return lobe::smith_correlated{}.G2(ndf, v, l);
    if (g.quantity == "G2_separable") return lobe::smith_separable{}.G2(ndf, v, l);
    if (g.quantity == "V") return lobe::smith_correlated{}.visibility(ndf, v, l);
    if (g.quantity == "f") return brdf.f(v, l);
    if (g.quantity == "f_cos") return brdf.f_cos(v, l);
    if (g.quantity == "pdf") return brdf.pdf(v, l);
    FAIL("an unknown quantity: " << g.quantity);
    return 0;
}

template <class T>
T of_fresnel(const golden& g) {
    const T c = static_cast<T>(g.v.z);
    if (g.quantity == "F_schlick_0.04") return lobe::schlick{T(0.04)}(c);
    if (g.quantity == "F_dielectric_1.5") return lobe::dielectric{T(1.5)}(c);
    if (g.quantity == "F_conductor_0.2_3.9") return lobe::conductor{T(0.2), T(3.9)}(c);
    FAIL("an unknown quantity: " << g.quantity);
    return 0;
}

template <class T>
T computed(const golden& g) {
    if (g.normals.empty()) return of_fresnel<T>(g);
    const lobe::alpha_xy<T> a{static_cast<T>(g.ax), static_cast<T>(g.ay)};
    return g.normals == "ggx" ? of_normals<T>(g, lobe::ggx{a}) : of_normals<T>(g, lobe::beckmann{a});
}

bool is_integral(const golden& g) { return std::string("EAB").find(g.quantity[0]) != std::string::npos; }

}  // namespace

TEMPLATE_TEST_CASE("golden values: every formula within the rounding of its inputs", "[golden]", float, double) {
    using T = TestType;
    std::map<std::string, double> worst;
    int count = 0;
    for (const golden& g : golden_values()) {
        if (is_integral(g)) continue;
        // Beckmann's Lambda is stated to 3e-5 in float and 4e-14 in double
        const double own = g.normals == "beckmann" && g.quantity == "Lambda" ? (sizeof(T) == 4 ? 3e-5 : 4e-14) : 0;
        const double epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
        const double error = std::abs(static_cast<double>(computed<T>(g)) / g.value - 1);
        if (8 * epsilon * (1 + g.condition) > 1) continue;  // of narrow lobes a float knows nothing there
        const double units = (error - own) / (epsilon * (1 + g.condition));
        double& w = worst[g.normals + " " + g.quantity];
        w = larger(w, units);
        INFO(g.normals << ' ' << g.ax << ' ' << g.ay << ' ' << g.quantity << " cosine " << g.v.z << " value "
                       << g.value);
        CHECK(units <= 8);
        ++count;
    }
    CHECK(count > 1000);
    std::ostringstream all;
    for (const auto& [name, units] : worst) all << name << ' ' << units << '\n';
    INFO(all.str());
    CHECK(worst.size() == 3 + 9 + 9);
}

TEST_CASE("golden values: albedos and averages", "[golden]") {
    std::map<std::string, int> counts;
    for (const golden& g : golden_values()) {
        if (!is_integral(g)) continue;
        const bool average = g.quantity.size() > 1;
        const auto of = [&](const auto& ndf) {
            const auto albedo = [&](const auto& fresnel) {
                const lobe::microfacet b{ndf, lobe::smith_correlated{}, fresnel};
                return average ? lobe::average_albedo(b).value : lobe::directional_albedo(b, g.v.z).value;
            };
            // of Schlick's reflectance E = F0 A + B
            const auto E = [&] { return albedo(lobe::perfect_reflector{}); };
            const auto B = [&] { return albedo(lobe::schlick{0.0}); };
            return g.quantity[0] == 'E' ? E() : g.quantity[0] == 'B' ? B() : E() - B();
        };
        const lobe::alpha<double> a{g.ax};
        INFO(g.normals << ' ' << g.ax << ' ' << g.quantity << " cosine " << g.v.z);
        CHECK(std::abs((g.normals == "ggx" ? of(lobe::ggx{a}) : of(lobe::beckmann{a})) - g.value) <
              2e-6);  // two of 1e-6
        ++counts[g.quantity];
    }
    for (const auto& [quantity, count] : counts) {
        INFO(quantity);
        CHECK(count == (quantity.size() > 1 ? 10 : 60));
    }
    CHECK(counts.size() == 6);
}
