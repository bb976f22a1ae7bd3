// What a verdict leaves behind where the subject ends the program: by an assert, a trap, a bad address.
#pragma once

#include <lobe/testkit/measure/text.hpp>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

namespace lobe::testkit::detail {

/// While it lives, a signal that ends the program first prints to stderr what was found so far and the input that was asked for, then goes
/// where it would have gone: to the handler that was there, or the end. Those handlers are back afterwards. In the signal nothing is
/// allocated and no lock is taken. Of several verdicts in as many threads, each prints its own.
class last_words {
public:
    using writer = std::function<void(line&)>;
    explicit last_words(writer of_input) : input(std::move(of_input)), outer(current) {
        current = this;
        const locked alone;
        if (users++ == 0)
            for (std::size_t i = 0; i < count; ++i) before[i] = exchange(ends[i], ours());
    }
    ~last_words() {
        current = outer;
        const locked alone;
        if (--users == 0) restore();
    }
    last_words(const last_words&) = delete;
    last_words& operator=(const last_words&) = delete;

    std::string so_far;

private:
    static constexpr int ends[] = {SIGABRT, SIGFPE, SIGILL, SIGSEGV};
    static constexpr std::size_t count = std::size(ends);

    // With POSIX, the whole of a handler: its mask, its stack, its arguments.
#if defined(__unix__) || defined(__APPLE__)
    using handler = struct sigaction;
    static handler ours() {
        handler h{};
        h.sa_handler = speak;
        return h;
    }
    static handler exchange(int which, const handler& h) {
        handler old{};
        sigaction(which, &h, &old);
        return old;
    }
#else
    using handler = void (*)(int);
    static handler ours() { return speak; }
    static handler exchange(int which, handler h) { return std::signal(which, h); }
#endif
    static void restore() {
        for (std::size_t i = 0; i < count; ++i) exchange(ends[i], before[i]);
    }

    static void print(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }
    static void speak(int which) {
        restore();
        if (const last_words* w = std::exchange(current, nullptr)) {
            line at;
            w->input(at);
            print("lobe::testkit: the subject ended the program, asked at\n      ");
            print(at.text());
            print("\nfound until then: ");
            print(w->so_far.empty() ? "nothing\n" : std::string_view(w->so_far));
        }
        std::raise(which);  // once this returns; a fault happens again by itself
    }

    struct locked {
        locked() {
            while (taken.test_and_set()) {
            }
        }
        ~locked() { taken.clear(); }
        locked(const locked&) = delete;
        locked& operator=(const locked&) = delete;
    };

    writer input;
    last_words* outer;
    static inline thread_local last_words* current = nullptr;
    static inline std::atomic_flag taken = ATOMIC_FLAG_INIT;
    static inline int users = 0;
    static inline handler before[count];
};

}  // namespace lobe::testkit::detail
