#include "progress.hpp"

#include <cmath>
#include <cstdio>

#include <unistd.h>

step::step(std::string name_, std::size_t parts_) : name(std::move(name_)), parts(parts_) { draw(0); }

step::~step() {
    if (isatty(STDERR_FILENO)) std::fputs("\r\x1b[K", stderr);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    std::printf("  %-44s %7.2f s\n", name.c_str(), time.count());
    std::fflush(stdout);
}

void step::advance() {
    const std::size_t finished = ++done;
    if (finished * 100 / parts != (finished - 1) * 100 / parts) draw(finished);
}

void step::draw(std::size_t finished) {
    static const bool terminal = isatty(STDERR_FILENO) != 0;
    if (!terminal) return;
    constexpr std::size_t width = 40;
    const std::size_t filled = finished * width / parts;
    const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    std::string left;
    if (finished > 0)
        left = ", " +
               std::to_string(
                   std::lround(time.count() * static_cast<double>(parts - finished) / static_cast<double>(finished))) +
               " s left";
    const std::lock_guard lock{drawing};
    std::fprintf(stderr, "\r  %s [%s] %zu %%%s\x1b[K", name.c_str(), bar.c_str(), finished * 100 / parts, left.c_str());
}
