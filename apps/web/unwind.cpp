// In builds with threads: the part of libunwind by which exceptions are caught. Emscripten 3.1.6's
// own keeps the context below in each thread's storage, where Clang 14's code does not look for it:
// nothing would ever be caught.
#include <cstdint>

#include <unwind.h>

struct LandingPadContext {
    std::uintptr_t index;  // of the place that asks, and its table
    std::uintptr_t table;
    std::uintptr_t selector;  // the answer
};

namespace {

LandingPadContext* of(_Unwind_Context* context) {
    return reinterpret_cast<LandingPadContext*>(context);
}

}  // namespace

extern "C" {

LandingPadContext __wasm_lpad_context;  // of all threads: what they run throws next to nothing

_Unwind_Reason_Code __gxx_personality_wasm0(int version, _Unwind_Action action,
                                            std::uint64_t exceptionClass,
                                            _Unwind_Exception* exception, _Unwind_Context* context);

_Unwind_Reason_Code _Unwind_CallPersonality(void* thrown) {
    auto* exception = static_cast<_Unwind_Exception*>(thrown);
    __wasm_lpad_context.selector = 0;
    return __gxx_personality_wasm0(1, _UA_CLEANUP_PHASE, exception->exception_class, exception,
                                   reinterpret_cast<_Unwind_Context*>(&__wasm_lpad_context));
}

_Unwind_Reason_Code _Unwind_RaiseException(_Unwind_Exception* exception) {
    __builtin_wasm_throw(0, exception);
}

void _Unwind_DeleteException(_Unwind_Exception* exception) {
    if (exception->exception_cleanup)
        exception->exception_cleanup(_URC_FOREIGN_EXCEPTION_CAUGHT, exception);
}

void _Unwind_SetGR(_Unwind_Context* context, int index, _Unwind_Word value) {
    if (index == 1) of(context)->selector = value;
}

_Unwind_Word _Unwind_GetIP(_Unwind_Context* context) {
    return of(context)->index + 2;  // counted from 1, and of the instruction after it
}

void _Unwind_SetIP(_Unwind_Context*, _Unwind_Word) {}

void* _Unwind_GetLanguageSpecificData(_Unwind_Context* context) {
    return reinterpret_cast<void*>(of(context)->table);
}

_Unwind_Ptr _Unwind_GetRegionStart(_Unwind_Context*) {
    return 0;
}
}
