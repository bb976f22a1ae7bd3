// error: deleted
// says: "scalar types only": a branch cannot be recorded
// of: if (x < real(1)) return x; return x < real(1) ? x : real(1)
#include <lobe/lobe.hpp>
#include <lobe/shader.hpp>

using lobe::shader::real;

// A shader cannot hold what only one path of the recording would show.
real shade(const real& x) {
#ifdef LOBE_SHOULD_COMPILE
    return lobe::smaller(x, real(1));
#else
    if (x < real(1)) return x;
    return real(1);
#endif
}
