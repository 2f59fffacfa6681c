// The C library's functions of analysis, done by the browser: their code would be a thirtieth of
// what a page fetches. JavaScript's are within an ulp or so, in double precision.
extern "C" {

#define TUKOR_UNARY(name)                                                                        \
    __attribute__((import_module("math"), import_name(#name))) double tukor_math_##name(double); \
    double name(double x) {                                                                      \
        return tukor_math_##name(x);                                                             \
    }                                                                                            \
    float name##f(float x) {                                                                     \
        return static_cast<float>(tukor_math_##name(x));                                         \
    }

#define TUKOR_BINARY(name)                                                                       \
    __attribute__((import_module("math"), import_name(#name))) double tukor_math_##name(double,  \
                                                                                        double); \
    double name(double x, double y) {                                                            \
        return tukor_math_##name(x, y);                                                          \
    }                                                                                            \
    float name##f(float x, float y) {                                                            \
        return static_cast<float>(tukor_math_##name(x, y));                                      \
    }

TUKOR_UNARY(sin)
TUKOR_UNARY(cos)
TUKOR_UNARY(tan)
TUKOR_UNARY(asin)
TUKOR_UNARY(acos)
TUKOR_UNARY(atan)
TUKOR_UNARY(exp)
TUKOR_UNARY(expm1)
TUKOR_UNARY(log)
TUKOR_UNARY(log2)
TUKOR_UNARY(cbrt)
TUKOR_BINARY(atan2)
TUKOR_BINARY(pow)

double exp2(double x) {
    return tukor_math_pow(2.0, x);
}
float exp2f(float x) {
    return static_cast<float>(tukor_math_pow(2.0, x));
}
}
