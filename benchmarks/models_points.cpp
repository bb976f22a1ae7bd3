// Sets of points in the unit square.
#include "models.hpp"

#include <lobe/sampling/lattices.hpp>
#include <lobe/sampling/sobol.hpp>

#include <cmath>
#include <cstdio>

namespace {

using lobe::alpha, lobe::ggx, lobe::microfacet, lobe::smith_correlated, lobe::vec2;

/// The root mean square error of E, the albedo of a GGX lobe with F = 1, by n visible normals: over 9 lobes and views,
/// and over 64 rounds, in each of which `points(round, n)` gives a set of its own.
template <class Points>
double error_of_albedo(std::uint32_t n, const Points& points) {
    constexpr std::uint32_t rounds = 64;
    double squares = 0;
    for (const double width : {0.05, 0.3, 0.8})
        for (const double mu : {0.95, 0.5, 0.1}) {
            const microfacet lobe{ggx{alpha{width}}, smith_correlated{}, lobe::perfect_reflector{}};
            const auto exact = lobe::dfg_exact(smith_correlated{}, mu, alpha{width}, {.order = 64});
            for (std::uint32_t round = 0; round < rounds; ++round) {
                const auto point = points(round, n);
                double total = 0;
                for (std::uint32_t i = 0; i < n; ++i)
                    total += lobe.sample({std::sqrt((1 - mu) * (1 + mu)), 0, mu}, point(i)).weight;
                const double off = total / n - (exact.scale + exact.bias);
                squares += off * off / (9 * rounds);
            }
        }
    return std::sqrt(squares);
}

/// A set, shifted around the square by two random numbers a round.
template <class Set>
auto shifted(const Set& set) {
    return [set](std::uint32_t round, std::uint32_t n) {
        const std::uint64_t bits = lobe::detail::seed_of(1, round, 0);
        const vec2<double> shift{lobe::detail::fraction<double>(static_cast<std::uint32_t>(bits)),
                                 lobe::detail::fraction<double>(static_cast<std::uint32_t>(bits >> 32))};
        return [set, shift, n](std::uint32_t i) {
            const vec2<double> u = set(i, n) + shift;
            return vec2<double>{u.x - std::floor(u.x), u.y - std::floor(u.y)};
        };
    };
}

std::vector<std::vector<std::string>> errors() {
    std::vector<std::vector<std::string>> table{{"error of E, n points"}};
    const std::vector<std::uint32_t> sizes{16, 64, 256, 1024};
    for (const std::uint32_t n : sizes) table[0].push_back("n = " + std::to_string(n));
    const auto add = [&](const char* label, const auto& points) {
        table.push_back({label});
        for (const std::uint32_t n : sizes) {
            char text[32];
            std::snprintf(text, sizeof text, "%.1e", error_of_albedo(n, points));
            table.back().push_back(text);
        }
    };
    add("random", [](std::uint32_t round, std::uint32_t) {
        return [round](std::uint32_t i) {
            const std::uint64_t bits = lobe::detail::seed_of(2, round, i);
            return vec2<double>{lobe::detail::fraction<double>(static_cast<std::uint32_t>(bits)),
                                lobe::detail::fraction<double>(static_cast<std::uint32_t>(bits >> 32))};
        };
    });
    add("`hammersley`, shifted",
        shifted([](std::uint32_t i, std::uint32_t n) { return lobe::hammersley<double>(i, n); }));
    add("`fibonacci`, shifted",
        shifted([](std::uint32_t i, std::uint32_t n) { return lobe::fibonacci<double>(i, n); }));
    add("`r2`, shifted", shifted([](std::uint32_t i, std::uint32_t) { return lobe::r2<double>(i); }));
    add("`sobol`, shifted", shifted([](std::uint32_t i, std::uint32_t) { return lobe::sobol<double>(i); }));
    add("`owen_sobol`", [](std::uint32_t round, std::uint32_t) {
        return [round](std::uint32_t i) { return lobe::owen_sobol<double>(i, round); };
    });
    return table;
}

}  // namespace

std::vector<section> point_set_models() {
    rows_of<itself> rows("Point sets", {{"coordinate", unit_of_error::absolute, 0, 2}});
    rows.add("`hammersley`",
             []<class T>(const element<T>& e) { return two(lobe::hammersley<T>(e.index(), e.in.points)); });
    rows.add("`fibonacci`",
             []<class T>(const element<T>& e) { return two(lobe::fibonacci<T>(e.index(), e.in.points)); });
    rows.add("`r2`", []<class T>(const element<T>& e) { return two(lobe::r2<T>(e.index())); });
    rows.add("`sobol`", []<class T>(const element<T>& e) { return two(lobe::sobol<T>(e.index())); });
    rows.add("`owen_sobol`",
             []<class T>(const element<T>& e) { return two(lobe::owen_sobol<T>(e.index(), e.in.points)); });
    rows.add("`scrambled_sobol`", []<class T>(const element<T>& e) {
        return two(lobe::scrambled_sobol<T>(e.in.points, 2, e.in.points)(1, e.index()));
    });
    if (exact_results_too) rows.made.extra = errors();
    return {rows.made};
}
