// For subjects that answer many questions in one call: what a piece of work will ask for is asked for before it is
// done.
#pragma once

#include <lobe/core/cpp20.hpp>

namespace lobe::testkit::detail {

/// While it listens, it notes what it is asked and does not know yet, and answers 0, or a failed sample.
class listener {
public:
    listener() = default;
    virtual ~listener() = default;
    listener(const listener&) = delete;
    listener& operator=(const listener&) = delete;

    /// Asks for all that was noted, in one call. False: for nothing.
    virtual bool ask() = 0;

    bool listens = false;
    static inline thread_local listener* current = nullptr;
};

inline bool rehearsing() { return listener::current && listener::current->listens; }

/// Nothing, but for such a subject: then does `work` twice, which may change nothing beyond what it is given to. First
/// it asks for samples and values that depend on nothing, then for values where the samples went. What it forgets to
/// ask for costs a call, no more.
template <class Work>
void rehearse(const Work& work) {
    listener* const all = listener::current;
    if (!all || all->listens) return;
    struct attention {
        bool& listens;
        explicit attention(bool& of) : listens(of) { listens = true; }
        ~attention() { listens = false; }
        attention(const attention&) = delete;
        attention& operator=(const attention&) = delete;
    };
    for (int i = 0; i < 2; ++i) {
        {
            const attention paid(all->listens);
            work();
        }
        if (!all->ask()) return;
    }
}

}  // namespace lobe::testkit::detail
