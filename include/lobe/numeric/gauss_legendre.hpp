// Gauss-Legendre quadrature: of any order, and of 32 points as constants.
#pragma once

#include <lobe/core/scalar.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace lobe {

/// int_0^1 g = sum w_i g(x_i), exact for polynomials of degree 2n - 1: nodes by Newton's method from Tricomi's first
/// guess. Allocates: host only. Scalar types only.
/// Error in double, up to n = 512: nodes 1e-16, weights relative 6e-15 n (the smallest, at the ends).
template <scalar T>
struct gauss_legendre {
    std::vector<T> x, w;

    explicit gauss_legendre(int n) : x(static_cast<std::size_t>(n)), w(static_cast<std::size_t>(n)) {
        using std::abs;
        for (int i = 0; i < (n + 1) / 2; ++i) {
            T z(std::cos(3.141592653589793 * (i + 0.75) / (n + 0.5)));
            T slope(0), step(1);
            for (int iteration = 0; iteration < 50 && abs(step) > T(2) * std::numeric_limits<T>::epsilon();
                 ++iteration) {
                T p(1), previous(0);
                for (int k = 0; k < n; ++k) {
                    const T next = z * p + (z * p - previous) * (T(k) / T(k + 1));
                    previous = p;
                    p = next;
                }
                slope = T(n) * (z * p - previous) / (z * z - T(1));
                step = p / slope;
                z -= step;
            }
            const auto low = static_cast<std::size_t>(i), high = static_cast<std::size_t>(n - 1 - i);
            x[low] = (T(1) - z) / T(2);
            x[high] = (T(1) + z) / T(2);
            w[low] = w[high] = T(1) / ((T(1) - z * z) * slope * slope);
        }
    }
};

/// The 32 nodes and weights on [-1,1] as constants, those of z > 0; -z has the same weight.
/// Abramowitz & Stegun 1964, table 25.4.
struct gauss_legendre_32 {
    double z[16] = {0.04830766568773831623, 0.1444719615827964935, 0.2392873622521370745, 0.3318686022821276498,
                    0.4213512761306353454,  0.50689990893222939,   0.587715757240762329,  0.663044266930215201,
                    0.7321821187402896804,  0.794483795967942407,  0.8493676137325699701, 0.896321155766052124,
                    0.9349060759377396892,  0.9647622555875064308, 0.9856115115452683354, 0.9972638618494815635};
    double w[16] = {0.09654008851472780057, 0.09563872007927485942, 0.09384439908080456564, 0.09117387869576388471,
                    0.08765209300440381114, 0.08331192422694675522, 0.07819389578707030647, 0.07234579410884850623,
                    0.06582222277636184684, 0.05868409347853554715, 0.0509980592623761762,  0.04283589802222668066,
                    0.0342738629130214331,  0.02539206530926205946, 0.01627439473090567061, 0.0070186100094700966};
};

}  // namespace lobe
