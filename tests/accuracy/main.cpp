// Measures every row in every region, float and double, and prints a line for each:
// name | type | region | points | worst | 99.9 % | mean | bound | unit | input. Exit 1 if a bound is exceeded; with --tight also if a
// bound is more than four times the worst error of its row.
#include "evaluate.hpp"
#include "rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <vector>

namespace {

using accuracy::inputs;

class generator {
public:
    explicit generator(std::uint64_t seed) : engine(seed) {}
    double operator()() { return static_cast<double>(engine() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * (*this)(); }
    double log_between(double low, double high) { return low * std::exp((*this)() * std::log(high / low)); }

private:
    std::mt19937_64 engine;
};

struct region {
    const char* name;
    void (*draw)(generator& random, double* x);
};

void direction(double* w, double sine, double cosine, double phi) {
    w[0] = sine * std::cos(phi);
    w[1] = sine * std::sin(phi);
    w[2] = cosine;
}
double turn(generator& random) { return random.between(0, 6.283185307179586); }

void tilted(generator& random, double* w, double sine) { direction(w, sine, std::sqrt((1 - sine) * (1 + sine)), turn(random)); }
void raised(generator& random, double* w, double cosine) { direction(w, std::sqrt((1 - cosine) * (1 + cosine)), cosine, turn(random)); }

void near_normal(generator& random, double* w) { tilted(random, w, random.log_between(1e-8, 1e-1)); }
void middle(generator& random, double* w) { raised(random, w, random.between(0.1, 0.99)); }
void grazing(generator& random, double* w) { raised(random, w, random.log_between(1e-6, 1e-1)); }
void anywhere_above(generator& random, double* w) {
    const double where = random();
    where < 0.3 ? near_normal(random, w) : where < 0.6 ? middle(random, w) : grazing(random, w);
}
void below(generator& random, double* w) { raised(random, w, -random()); }

void one_width(generator& random, double* x) { x[0] = x[1] = random.log_between(1e-6, 1); }
void two_widths(generator& random, double* x) {
    x[0] = random.log_between(1e-3, 1);
    x[1] = x[0] * random.log_between(1e-3, 1);
    if (random() < 0.5) std::swap(x[0], x[1]);
}

/// l mirrored about a normal whose slope is some alphas: half vectors as lobes have them.
void lobe_around(generator& random, const double* x, const double* v, double* l) {
    const double r = random.log_between(0.01, 30), phi = turn(random);
    const double mx = r * x[0] * std::cos(phi), my = r * x[1] * std::sin(phi), m2 = mx * mx + my * my + 1;
    const double v_m = v[0] * mx + v[1] * my + v[2];
    l[0] = 2 * v_m * mx / m2 - v[0];
    l[1] = 2 * v_m * my / m2 - v[1];
    l[2] = 2 * v_m / m2 - v[2];
}

template <void (*Width)(generator&, double*), void (*Direction)(generator&, double*)>
void widths_and(generator& random, double* x) {
    Width(random, x);
    Direction(random, x + 2);
}

template <void (*Width)(generator&, double*), void (*V)(generator&, double*), void (*L)(generator&, double*)>
void widths_and_two(generator& random, double* x) {
    Width(random, x);
    V(random, x + 2);
    L(random, x + 5);
}

template <void (*Width)(generator&, double*), void (*V)(generator&, double*)>
void in_the_lobe(generator& random, double* x) {
    do {
        Width(random, x);
        V(random, x + 2);
        lobe_around(random, x, x + 2, x + 5);
    } while (!(x[7] > 1e-6));
}

/// v and l nearly opposite each other, both grazing.
template <void (*Width)(generator&, double*)>
void antiparallel(generator& random, double* x) {
    Width(random, x);
    const double phi = turn(random), off = random.log_between(1e-6, 1e-2), cv = random.log_between(1e-6, 1e-2),
                 cl = random.log_between(1e-6, 1e-2);
    direction(x + 2, std::sqrt((1 - cv) * (1 + cv)), cv, phi);
    direction(x + 5, std::sqrt((1 - cl) * (1 + cl)), cl, phi + 3.141592653589793 + off);
}

template <void (*Width)(generator&, double*)>
std::vector<region> pair_regions() {
    return {{"in the lobe", in_the_lobe<Width, middle>},
            {"in the lobe, near the normal", in_the_lobe<Width, near_normal>},
            {"in the lobe, grazing", in_the_lobe<Width, grazing>},
            {"any two", widths_and_two<Width, middle, middle>},
            {"one grazing", widths_and_two<Width, middle, grazing>},
            {"both grazing", widths_and_two<Width, grazing, grazing>},
            {"nearly antiparallel", antiparallel<Width>}};
}

template <void (*Width)(generator&, double*)>
std::vector<region> view_regions() {
    return {{"near the normal", widths_and<Width, near_normal>},
            {"middle", widths_and<Width, middle>},
            {"grazing", widths_and<Width, grazing>}};
}

template <void (*Width)(generator&, double*)>
std::vector<region> normal_regions() {
    auto regions = view_regions<Width>();
    regions.push_back({"any length", [](generator& random, double* x) {
                           Width(random, x);
                           tilted(random, x + 2, random.log_between(1e-8, 1));
                           const double size = random.log_between(1e-6, 1e6);
                           for (int i = 2; i < 5; ++i) x[i] *= size;
                       }});
    return regions;
}

void peers_width(generator&, double* x) { x[0] = x[1] = 1e-4; }
void any_square(generator& random, double* u) { u[0] = random(), u[1] = random(); }
/// Towards 0 and towards 1, where radii and cosines vanish.
void edges(generator& random, double* u) {
    for (int i = 0; i < 2; ++i) u[i] = random() < 0.5 ? random.log_between(1e-9, 1) : 1 - random.log_between(0x1p-24, 1);
}

template <void (*Width)(generator&, double*), void (*U)(generator&, double*), void (*Direction)(generator&, double*)>
void widths_square_and(generator& random, double* x) {
    Width(random, x);
    U(random, x + 2);
    Direction(random, x + 4);
}

template <void (*Width)(generator&, double*)>
std::vector<region> square_regions() {
    return {{"any", widths_and<Width, any_square>}, {"edges", widths_and<Width, edges>}};
}

std::vector<region> regions_of(inputs takes) {
    switch (takes) {
        case inputs::turn: return {{"[0,1)", [](generator& random, double* x) { x[0] = random(); }}};
        case inputs::cosine:
            return {{"grazing", [](generator& random, double* x) { x[0] = random.log_between(1e-6, 1e-1); }},
                    {"middle", [](generator& random, double* x) { x[0] = random.between(0.1, 0.99); }},
                    {"near the normal", [](generator& random, double* x) { x[0] = 1 - random.log_between(1e-7, 1e-2); }}};
        case inputs::normal: return normal_regions<one_width>();
        case inputs::normal_xy: return normal_regions<two_widths>();
        case inputs::view: return view_regions<one_width>();
        case inputs::view_xy: return view_regions<two_widths>();
        case inputs::view_below: return {{"one width", widths_and<one_width, below>}, {"two widths", widths_and<two_widths, below>}};
        case inputs::pair: return pair_regions<one_width>();
        case inputs::pair_xy: return pair_regions<two_widths>();
        case inputs::index: return {{"0.3 to 10", [](generator& random, double* x) { x[0] = random.log_between(0.3, 10); }}};
        case inputs::reflectance: return {{"to 1/4", [](generator& random, double* x) { x[0] = random.log_between(1e-6, 0.25); }}};
        case inputs::square: return square_regions<one_width>();
        case inputs::square_of: {
            auto regions = square_regions<one_width>();
            regions.push_back({"alpha 1e-4", widths_and<peers_width, any_square>});
            return regions;
        }
        case inputs::square_of_xy: return square_regions<two_widths>();
        case inputs::seen:
            return {{"any", widths_square_and<one_width, any_square, anywhere_above>},
                    {"alpha 1e-4", widths_square_and<peers_width, any_square, anywhere_above>}};
        case inputs::seen_xy: return {{"any", widths_square_and<two_widths, any_square, anywhere_above>}};
        case inputs::seen_below: return {{"any", widths_square_and<one_width, any_square, below>}};
        case inputs::roughness:
            return {{"[0.01,1] x [0,0.999]",
                     [](generator& random, double* x) { x[0] = random.between(0.01, 1), x[1] = random.between(0, 0.999); }}};
        case inputs::direction:
            return {{"any", [](generator& random, double* x) { raised(random, x, random.between(-1, 1)); }},
                    {"near -n", [](generator& random, double* x) { tilted(random, x, random.log_between(1e-8, 1e-1)), x[2] = -x[2]; }}};
    }
    return {};
}

}  // namespace

int main(int argc, char** argv) {
    int points = 1000;
    bool tight = false;
    for (int i = 1; i < argc; ++i) {
        if (!std::strcmp(argv[i], "--tight"))
            tight = true;
        else if (std::atoi(argv[i]) > 1)
            points = std::atoi(argv[i]);
        else
            return std::fprintf(stderr, "usage: accuracy [points] [--tight]\n"), 2;
    }
    const char* const names[] = {"ULP", "ULP of 1", "ULP (1+&#124;ln&#124;)", "radian", "of the radius"};
    const auto rows = accuracy::rows<double>();
    int failed = 0;
    std::vector<double> errors(static_cast<std::size_t>(points));
    for (std::size_t r = 0; r < rows.size(); ++r)
        for (const bool is_float : {true, false}) {
            const auto& promise = rows[r];
            const char* const type = is_float ? "float" : "double";
            const double scale = is_float || !promise.direction ? 1 : 0x1p-29;
            const double bound = promise.bound * scale, most_bound = promise.most * scale;
            double worst_of_row = 0, most_of_row = 0;
            for (const region& where : regions_of(promise.takes)) {
                generator random(1000 * r + 1);
                double worst = 0, sum = 0, worst_x[8] = {};
                for (double& error : errors) {
                    double x[8] = {};
                    where.draw(random, x);
                    if (is_float)
                        for (double& component : x) component = static_cast<double>(static_cast<float>(component));
                    const int row = static_cast<int>(r);
                    error = is_float ? accuracy::error_of_float(row, x, accuracy::value_in_float(row, x))
                                     : accuracy::error_of_double(row, x, accuracy::value_in_double(row, x));
                    sum += error;
                    if (!(error <= worst)) worst = error, std::copy(x, x + 8, worst_x);
                }
                const auto quantile = errors.end() - 2 - static_cast<std::ptrdiff_t>(errors.size() / 1000);
                std::nth_element(errors.begin(), quantile, errors.end());
                const double most = *quantile;
                std::printf("%s | %s | %s | %d | %.3g | %.3g | %.2g | %.2g", promise.name, type, where.name, points, worst, most,
                            sum / points, bound);
                if (most_bound < bound) std::printf(", %.2g for 99.9 %%", most_bound);
                std::printf(" | %s |", names[static_cast<int>(promise.in)]);
                for (const double component : worst_x) std::printf(is_float ? " %.9g" : " %.17g", component);
                std::printf("\n");
                const auto broken = [&](const char* what, double error, double promised) {
                    ++failed;
                    std::fprintf(stderr, "%s (%s, %s): %s %.3g, promised %g\n", promise.name, type, where.name, what, error, promised);
                };
                if (!(worst <= bound)) broken("worst", worst, bound);
                if (!(most <= most_bound)) broken("99.9 %", most, most_bound);
                worst_of_row = std::max(worst_of_row, worst);
                most_of_row = std::max(most_of_row, most);
            }
            const double measured = most_bound < bound ? most_of_row : worst_of_row;
            if (tight && most_bound > 4 * measured)
                ++failed, std::fprintf(stderr, "%s (%s): promised %g, more than four times the measured %.3g\n", promise.name, type,
                                       most_bound, measured);
        }
    return failed ? 1 : 0;
}
