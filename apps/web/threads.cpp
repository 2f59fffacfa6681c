// In builds with threads: what web/src/tukor-threads.js asks of every module.
#include <emscripten/emscripten.h>
#include <pthread.h>

#include "answers.h"
#include "tukor/base/parallel.h"

extern "C" {

/// As many from now on, with the one that calls.
EMSCRIPTEN_KEEPALIVE int threads_count(int count) {
    return tukor::web::guarded([&] {
        tukor::setThreadCount(count);
        return 0;
    });
}

/// Where the stack of a new one begins: at its end.
EMSCRIPTEN_KEEPALIVE void* threads_stack(pthread_t thread) {
    pthread_attr_t attributes;
    void* least = nullptr;
    std::size_t size = 0;
    pthread_getattr_np(thread, &attributes);
    pthread_attr_getstack(&attributes, &least, &size);
    return static_cast<std::byte*>(least) + size;
}

/// Pieces of loops that the calling one, hired for them, has done.
EMSCRIPTEN_KEEPALIVE int threads_pieces() {
    return tukor::piecesHelped();
}
}
