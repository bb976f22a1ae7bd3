#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

/// One step of the work: a bar on stderr while it runs, if that is a terminal, and its time on stdout when it ends.
class step {
public:
    step(std::string name, std::size_t parts);
    ~step();
    step(const step&) = delete;
    step& operator=(const step&) = delete;

    void advance();  // one part is done; from any thread

private:
    std::string name;
    std::size_t parts;
    std::atomic<std::size_t> done = 0;
    std::mutex drawing;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

    void draw(std::size_t finished);
};
