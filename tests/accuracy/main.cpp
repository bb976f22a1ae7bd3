// Measures every row in every region, float and double, and prints a line for each:
// name | type | region | points | worst | 99.9 % | mean | bound | unit | worst input. Exit 1 if a bound is exceeded;
// with --tight also if it is more than four times the worst error of its row. Points beyond the type's range are left
// out.
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

void tilted(generator& random, double* w, double sine) {
    direction(w, sine, std::sqrt((1 - sine) * (1 + sine)), turn(random));
}
void raised(generator& random, double* w, double cosine) {
    direction(w, std::sqrt((1 - cosine) * (1 + cosine)), cosine, turn(random));
}

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
    x[0] = random.log_between(1e-6, 1);
    x[1] = x[0] * random.log_between(std::max(1e-3, 1e-6 / x[0]), 1);
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
            {"l grazing", widths_and_two<Width, anywhere_above, grazing>},
            {"v grazing", widths_and_two<Width, grazing, anywhere_above>},
            {"both grazing", widths_and_two<Width, grazing, grazing>},
            {"nearly antiparallel", antiparallel<Width>}};
}

template <void (*Width)(generator&, double*)>
std::vector<region> view_regions() {
    return {{"near the normal", widths_and<Width, near_normal>},
            {"middle", widths_and<Width, middle>},
            {"grazing", widths_and<Width, grazing>}};
}

/// Normals of the surface, its slopes some alphas.
template <void (*Width)(generator&, double*)>
void some_widths_off(generator& random, double* x) {
    Width(random, x);
    const double r = random.log_between(0.01, 30), phi = turn(random), mx = r * x[0] * std::cos(phi),
                 my = r * x[1] * std::sin(phi);
    const double size = std::sqrt(mx * mx + my * my + 1);
    x[2] = mx / size, x[3] = my / size, x[4] = 1 / size;
}

template <void (*Width)(generator&, double*)>
void any_length(generator& random, double* x) {
    Width(random, x);
    anywhere_above(random, x + 2);
    for (int i = 0; i < 2; ++i) x[i] = std::max(x[i], 1e-3);
    const double size = random.log_between(1e-6, 1e6);
    for (int i = 2; i < 5; ++i) x[i] *= size;
}

template <void (*Width)(generator&, double*)>
std::vector<region> normal_regions() {
    auto regions = view_regions<Width>();
    regions.push_back({"some widths off the normal", some_widths_off<Width>});
    regions.push_back({"any length", any_length<Width>});
    return regions;
}

void width_from_1e_2(generator& random, double* x) { x[0] = x[1] = random.log_between(1e-2, 1); }
void peers_width(generator&, double* x) { x[0] = x[1] = 1e-4; }
void any_square(generator& random, double* u) { u[0] = random(), u[1] = random(); }
/// Towards 0 and towards 1, where radii and cosines vanish.
void edges(generator& random, double* u) {
    for (int i = 0; i < 2; ++i)
        u[i] = random() < 0.5 ? random.log_between(1e-9, 1) : 1 - random.log_between(0x1p-24, 1);
}

/// Towards the point of the square where the facets seen from v close.
void closing(generator& random, double* u, const double* v) {
    u[0] = 1 - random.log_between(0x1p-24, 1);
    const double opposite =
        std::atan2(-v[1], -v[0]) / 6.283185307179586 + (random() - 0.5) * random.log_between(1e-7, 1) + 2;
    u[1] = opposite - std::floor(opposite);
}

template <void (*Width)(generator&, double*), void (*U)(generator&, double*), void (*Direction)(generator&, double*)>
void widths_square_and(generator& random, double* x) {
    Width(random, x);
    U(random, x + 2);
    Direction(random, x + 4);
}
template <void (*Width)(generator&, double*), void (*Direction)(generator&, double*)>
void widths_closing_and(generator& random, double* x) {
    Width(random, x);
    Direction(random, x + 4);
    closing(random, x + 2, x + 4);
}

template <void (*Width)(generator&, double*)>
std::vector<region> square_regions() {
    return {{"any", widths_and<Width, any_square>}, {"edges", widths_and<Width, edges>}};
}
template <void (*Width)(generator&, double*), void (*V)(generator&, double*)>
std::vector<region> seen_regions() {
    return {{"any", widths_square_and<Width, any_square, V>},
            {"edges", widths_square_and<Width, edges, V>},
            {"where facets close", widths_closing_and<Width, V>}};
}

std::vector<region> regions_of(inputs takes) {
    switch (takes) {
        case inputs::turn: return {{"[0,1)", [](generator& random, double* x) { x[0] = random(); }}};
        case inputs::cosine:
            return {
                {"grazing", [](generator& random, double* x) { x[0] = random.log_between(1e-6, 1e-1); }},
                {"middle", [](generator& random, double* x) { x[0] = random.between(0.1, 0.99); }},
                {"near the normal", [](generator& random, double* x) { x[0] = 1 - random.log_between(1e-7, 1e-2); }}};
        case inputs::normal: return normal_regions<one_width>();
        case inputs::normal_xy: return normal_regions<two_widths>();
        case inputs::view: return view_regions<one_width>();
        case inputs::view_xy: return view_regions<two_widths>();
        case inputs::view_below:
            return {{"one width", widths_and<one_width, below>}, {"two widths", widths_and<two_widths, below>}};
        case inputs::pair: return pair_regions<one_width>();
        case inputs::pair_xy: return pair_regions<two_widths>();
        case inputs::index:
            return {{"0.3 to 10", [](generator& random, double* x) { x[0] = random.log_between(0.3, 10); }}};
        case inputs::reflectance:
            return {{"to 1/4", [](generator& random, double* x) { x[0] = random.log_between(1e-6, 0.25); }}};
        case inputs::square: return square_regions<one_width>();
        case inputs::square_of: {
            auto regions = square_regions<one_width>();
            regions.push_back({"alpha 1e-4", widths_and<peers_width, any_square>});
            return regions;
        }
        case inputs::square_of_xy: return square_regions<two_widths>();
        case inputs::seen: return seen_regions<one_width, anywhere_above>();
        case inputs::seen_narrow: return seen_regions<peers_width, anywhere_above>();
        case inputs::seen_xy: return seen_regions<two_widths, anywhere_above>();
        case inputs::seen_below: return seen_regions<width_from_1e_2, below>();
        case inputs::index_cosine:
            return {{"any", [](generator& random, double* x) { x[0] = random.between(1, 10), x[1] = random(); }},
                    {"eta near 1",
                     [](generator& random, double* x) { x[0] = 1 + random.log_between(1e-3, 1), x[1] = random(); }},
                    {"near the normal",
                     [](generator& random, double* x) {
                         x[0] = 1 + random.log_between(1e-3, 9), x[1] = 1 - random.log_between(1e-7, 1e-1);
                     }},
                    {"grazing", [](generator& random, double* x) {
                         x[0] = 1 + random.log_between(1e-3, 9), x[1] = random.log_between(1e-6, 1e-1);
                     }}};
        case inputs::roughness:
            return {{"[0.01,1] x [0,0.999]", [](generator& random, double* x) {
                         x[0] = random.between(0.01, 1), x[1] = random.between(0, 0.999);
                     }}};
        case inputs::direction:
            return {{"any", [](generator& random, double* x) { raised(random, x, random.between(-1, 1)); }},
                    {"near -n", [](generator& random, double* x) {
                         tilted(random, x, random.log_between(1e-8, 1e-1)), x[2] = -x[2];
                     }}};
    }
    return {};
}

}  // namespace

/// Where a row's inputs begin in x, and how many there are.
struct span {
    int first, count;
};
span inputs_of(inputs takes) {
    switch (takes) {
        case inputs::turn:
        case inputs::cosine:
        case inputs::index:
        case inputs::reflectance: return {0, 1};
        case inputs::index_cosine:
        case inputs::roughness: return {0, 2};
        case inputs::square: return {2, 2};
        case inputs::direction: return {0, 3};
        case inputs::square_of:
        case inputs::square_of_xy: return {0, 4};
        case inputs::seen:
        case inputs::seen_narrow:
        case inputs::seen_xy:
        case inputs::seen_below: return {0, 7};
        case inputs::pair:
        case inputs::pair_xy: return {0, 8};
        default: return {0, 5};
    }
}

int main(int argc, char** argv) {
    int points = 1000;
    bool tight = false;
    const char* only = "";
    for (int i = 1; i < argc; ++i) {
        if (!std::strcmp(argv[i], "--tight"))
            tight = true;
        else if (!std::strcmp(argv[i], "--only") && i + 1 < argc)
            only = argv[++i];
        else if (std::atoi(argv[i]) > 0)
            points = std::atoi(argv[i]);
        else
            return std::fprintf(stderr, "usage: accuracy [points] [--tight] [--only PART_OF_A_NAME]\n"), 2;
    }
    const char* const names[] = {"ULP",   "ULP of 1", "ULP, exponential", "ULP, power", "radian", "radian, conditioned",
                                 "radius"};
    const auto rows = accuracy::rows<double>();
    int failed = 0;
    for (std::size_t r = 0; r < rows.size(); ++r)
        for (const bool is_float : {true, false}) {
            const auto& promise = rows[r];
            if (!std::strstr(promise.name, only)) continue;
            const char* const type = is_float ? "float" : "double";
            const double bound = promise.bound * (is_float || !promise.direction ? 1 : 0x1p-29);
            const auto fail = [&](const char* what, double error) {
                ++failed;
                std::fprintf(stderr, "%s (%s): promised %g, %s %.3g\n", promise.name, type, bound, what, error);
            };
            double worst_of_row = 0;
            for (const region& where : regions_of(promise.takes)) {
                generator random(1000 * r + 1);
                std::vector<double> errors;
                double worst = 0, sum = 0, worst_x[8] = {};
                for (int i = 0; i < points; ++i) {
                    double x[8] = {};
                    where.draw(random, x);
                    if (is_float)
                        for (double& component : x) component = static_cast<double>(static_cast<float>(component));
                    const int row = static_cast<int>(r);
                    const double error = is_float
                                             ? accuracy::error_of_float(row, x, accuracy::value_in_float(row, x))
                                             : accuracy::error_of_double(row, x, accuracy::value_in_double(row, x));
                    if (error < 0) continue;
                    errors.push_back(error);
                    sum += error;
                    if (error > worst) worst = error, std::copy(x, x + 8, worst_x);
                }
                // out of the type's range, nearly all of them
                if (errors.size() < static_cast<std::size_t>(points) / 20) continue;
                const auto quantile = errors.end() - 1 - static_cast<std::ptrdiff_t>(errors.size() / 1000);
                std::nth_element(errors.begin(), quantile, errors.end());
                std::printf("%s | %s | %s | %zu | %.3g | %.3g | %.2g | %.2g | %s |", promise.name, type, where.name,
                            errors.size(), worst, *quantile, sum / static_cast<double>(errors.size()), bound,
                            names[static_cast<int>(promise.in)]);
                const auto [first, count] = inputs_of(promise.takes);
                for (int i = first; i < first + count; ++i) std::printf(is_float ? " %.9g" : " %.17g", worst_x[i]);
                std::printf("\n");
                if (!(worst <= bound)) fail(where.name, worst);
                worst_of_row = std::max(worst_of_row, worst);
            }
            if (tight && bound > 4 * worst_of_row) fail("more than four times", worst_of_row);
        }
    return failed ? 1 : 0;
}
