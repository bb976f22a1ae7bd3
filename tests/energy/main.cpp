// Measures the models of multiple scattering against the random walk: the rows of docs/energy.md and of its plot.
// energy_models DATA_FOLDER: prints the tables, writes by_F0.dat, by_alpha.dat
#include "../support.hpp"

#include <lobe/lobe.hpp>

#include <array>
#include <chrono>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>

namespace {

using lobe::alpha, lobe::schlick, lobe::vec3;

constexpr std::array F0s{0., .02, .04, .08, .15, .25, .35, .45, .55, .65, .75, .85, .95, 1.};

/// The exact terms of one place.
struct terms_of_row {
    lobe::dfg_terms<double> here, average_terms;
    lobe::dfg_terms<double> operator()(double, const alpha<double>&) const { return here; }
    lobe::dfg_terms<double> average(const alpha<double>&) const { return average_terms; }
};

double sum(const lobe::ibl_weights<double>& w) { return w.radiance + w.irradiance; }

struct model {
    std::string name, source;
    std::function<double(const terms_of_row&, double mu, double a, double F0)> albedo;
};

const std::vector<model> models{
    {"single scattering", "Cook & Torrance 1982",
     [](const terms_of_row& t, double, double, double F0) { return F0 * t.here.scale + t.here.bias; }},
    {"`turquin`", "Turquin 2019",
     [](const terms_of_row& t, double mu, double a, double F0) {
         return sum(lobe::turquin{t}.weights(schlick{F0}, mu, alpha{a}));
     }},
    {"`fdez_aguera`", "Fdez-Aguera 2019",
     [](const terms_of_row& t, double, double, double F0) { return sum(lobe::fdez_aguera{}(t.here, F0)); }},
    {"`kulla_conty`", "Kulla & Conty 2017, Hill 2018",
     [](const terms_of_row& t, double mu, double a, double F0) {
         return sum(lobe::kulla_conty{t}.weights(schlick{F0}, mu, alpha{a}));
     }},
    {"`smith_multiscatter`", "fitted to the walk",
     [](const terms_of_row& t, double mu, double a, double F0) {
         return sum(lobe::smith_multiscatter{t}.weights(schlick{F0}, mu, alpha{a}));
     }},
};

struct error {
    double largest = 0, squares = 0;
    int count = 0;
    void add(double off) {
        largest = larger(largest, std::abs(off));
        squares += off * off;
        ++count;
    }
    double rms() const { return std::sqrt(squares / count); }
};

std::string text(double x, int digits = 2) {
    std::ostringstream out;
    if (x < 1e-6)  // the grid has seven digits
        out << "0";
    else if (x >= 10)
        out << std::lround(x);
    else
        out << std::setprecision(digits) << x;
    return out.str();
}

/// The largest |f(v,l)/f(l,v) - 1| for cosines from 0.1, at F0 = 0.5.
template <class F>
double asymmetry(const F& f) {
    random_numbers random(3);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto direction = [&] {
            const double z = random.between(0.1, 1), phi = random.between(0, 6.283185307179586);
            const double sine = std::sqrt((1 - z) * (1 + z));
            return vec3<double>{sine * std::cos(phi), sine * std::sin(phi), z};
        };
        const vec3<double> v = direction(), l = direction();
        const double a = std::pow(10.0, random.between(-1.3, 0));
        worst = larger(worst, std::abs(f(v, l, a) / f(l, v, a) - 1));
    }
    return worst;
}

/// The median time of one call in ns, of 31 runs over 4096 inputs.
template <class G>
double nanoseconds(const G& g) {
    random_numbers random(4);
    std::vector<vec3<float>> v, l;
    std::vector<float> a;
    for (int i = 0; i < 4096; ++i) {
        const auto up = [&] {
            vec3<double> w = random.direction();
            w.z = std::abs(w.z);
            return vec3<float>(w);
        };
        v.push_back(up());
        l.push_back(up());
        a.push_back(static_cast<float>(random.between(0.05, 1)));
    }
    std::vector<double> times;
    float keep = 0;
    for (int run = 0; run < 31; ++run) {
        const auto start = std::chrono::steady_clock::now();
        for (std::size_t i = 0; i < v.size(); ++i) keep += g(v[i], l[i], alpha<float>(a[i]));
        const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
        times.push_back(took.count() / static_cast<double>(v.size()));
    }
    volatile float kept = keep;
    static_cast<void>(kept);
    std::nth_element(times.begin(), times.begin() + 15, times.end());
    return times[15];
}

template <class T>
auto gold(const alpha<T>& a) {
    return lobe::microfacet{lobe::ggx{a}, lobe::smith_correlated{}, schlick{vec3<T>{T(1), T(0.71f), T(0.29f)}}};
}

template <class Make>
void brdf_row(const std::string& name, const Make& make) {
    const auto f_cos = [&](const vec3<float>& v, const vec3<float>& l, const alpha<float>& a) {
        return make(gold(a)).f_cos(v, l).y;
    };
    const auto sample = [&](const vec3<float>& v, const vec3<float>& l, const alpha<float>& a) {
        return make(gold(a)).sample(v, {l.z, l.x * 0.49f + 0.5f}).weight.y;
    };
    const auto f = [&](const vec3<double>& v, const vec3<double>& l, double a) {
        return make(lobe::microfacet{lobe::ggx{alpha{a}}, lobe::smith_correlated{}, schlick{0.5}}).f(v, l);
    };
    const double off = asymmetry(f);
    std::cout << "| " << name << " | " << (off < 1e-12 ? "yes" : "no, " + text(100 * off) + " %") << " | "
              << text(nanoseconds(f_cos)) << " | " << text(nanoseconds(sample)) << " |\n";
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) throw std::runtime_error("energy_models DATA_FOLDER");
    const std::string folder = argv[1];
    std::map<double, lobe::dfg_terms<double>> averages;
    std::vector<std::map<double, error>> by_F0(models.size()), by_alpha(models.size());
    std::vector<error> all(models.size());
    for (const auto& row : reference_table("random_walk_grid.csv")) {
        const double mu = row[0], a = row[1];
        if (mu < 0.02 || a < 0.05) continue;
        if (!averages.count(a)) averages[a] = lobe::exact_dfg<lobe::smith_correlated>{}.average(alpha{a});
        const terms_of_row terms{{row[2], row[3]}, averages[a]};
        for (std::size_t i = 0; i < F0s.size(); ++i)
            for (std::size_t m = 0; m < models.size(); ++m) {
                const double truth = F0s[i] * row[2] + row[3] + row[4 + i];
                const double off = models[m].albedo(terms, mu, a, F0s[i]) - truth;
                by_F0[m][F0s[i]].add(off);
                by_alpha[m][a].add(off);
                all[m].add(off);
            }
    }

    std::cout << "| model | source | largest | rms |";
    const std::array shown{0., .04, .15, .35, .55, .75, .95, 1.};
    for (double F0 : shown) std::cout << " F0 " << F0 << " |";
    std::cout << "\n|:--|:--|--:|--:|";
    for (std::size_t i = 0; i < shown.size(); ++i) std::cout << "--:|";
    std::cout << "\n";
    for (std::size_t m = 0; m < models.size(); ++m) {
        std::cout << "| " << models[m].name << " | " << models[m].source << " | " << text(all[m].largest) << " | "
                  << text(all[m].rms()) << " |";
        for (double F0 : shown) std::cout << " " << text(by_F0[m][F0].largest) << " |";
        std::cout << "\n";
    }
    const auto write = [&](const std::string& name, const std::vector<std::map<double, error>>& errors) {
        std::ofstream out(folder + "/" + name);
        for (const auto& [x, first] : errors[0]) {
            out << x;
            for (const auto& of_model : errors) out << ' ' << larger(of_model.at(x).largest, 1e-5);
            out << '\n';
        }
        if (!out.good()) throw std::runtime_error("cannot write " + folder + "/" + name);
    };
    write("by_F0.dat", by_F0);
    write("by_alpha.dat", by_alpha);

    std::cout << "\n| BRDF | reciprocal | `f_cos`, ns | `sample`, ns |\n|:--|:--|--:|--:|\n";
    using lobe::compensated;
    brdf_row("`microfacet`, no compensation", [](const auto& b) { return b; });
    brdf_row("`turquin`", [](const auto& b) { return compensated{b, lobe::turquin{}}; });
    brdf_row("`kulla_conty`", [](const auto& b) { return compensated{b, lobe::kulla_conty{}}; });
    brdf_row("`smith_multiscatter`", [](const auto& b) { return compensated{b}; });
    brdf_row("`smith_multiscatter`, `forward()`", [](const auto& b) {
        return compensated{b, lobe::smith_multiscatter{}.forward()};
    });
    brdf_row("`smith_multiscatter`, terms from `dfg_fit_cheap`", [](const auto& b) {
        return compensated{b, lobe::smith_multiscatter{lobe::dfg_fit_cheap{}}};
    });

    std::cout << "\n| weights for image-based light | ns |\n|:--|--:|\n";
    const auto weights_row = [&](const std::string& name, const auto& weights) {
        std::cout << "| " << name << " | " << text(nanoseconds([&](const auto& v, const auto&, const auto& a) {
            const auto w = weights(schlick{vec3<float>{1.0f, 0.71f, 0.29f}}, v.z, a);
            return w.radiance.y + w.irradiance.y;
        })) << " |\n";
    };
    weights_row("`turquin`", [](const auto& F, float mu, const auto& a) { return lobe::turquin{}.weights(F, mu, a); });
    weights_row("`fdez_aguera`", [](const auto& F, float mu, const auto& a) {
        return lobe::fdez_aguera{}(lobe::default_dfg{}(mu, a), F.F0());
    });
    weights_row("`kulla_conty`",
                [](const auto& F, float mu, const auto& a) { return lobe::kulla_conty{}.weights(F, mu, a); });
    weights_row("`smith_multiscatter`",
                [](const auto& F, float mu, const auto& a) { return lobe::smith_multiscatter{}.weights(F, mu, a); });
} catch (const std::exception& e) {
    std::cerr << "energy_models: " << e.what() << '\n';
    return 1;
}
