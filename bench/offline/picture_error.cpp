// Errors of pictures against the mean of two references, for offline.py.
//
// usage: picture_error REFERENCE1 REFERENCE2 [PICTURE...]
//
// A line each: RMSE of radiance, relative MSE, RMSE in 8-bit sRGB. The first is the references' own
// noise, half their distance; then one per picture; the last, of two pictures or more, is what all
// of them have in common against the reference, however noisy each is: the root of the mean product
// of the first two's errors (relative: the mean product), negative where the product is.
#include <cmath>
#include <cstdio>
#include <exception>
#include <vector>

#include "tukor/base/error.h"
#include "tukor/image/image_file.h"

namespace {

using tukor::Image;

/// Of squared relative errors: 0.1 is the radiance below which errors count as absolute ones.
constexpr float kDark = 0.1f;

struct Errors {
    double squares = 0.0;   // mean product of the errors in radiance
    double relative = 0.0;  // over reference^2 + kDark^2
    double codes = 0.0;     // mean product of the errors in 8-bit sRGB codes
};

float codeOf(float radiance) {
    const float x = std::fmin(std::fmax(radiance, 0.0f), 1.0f);
    const float s = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
    return std::floor(255.0f * s + 0.5f);
}

/// Mean products of the errors of `a` and of `b`; of one picture with itself, its mean squares.
Errors products(const Image& a, const Image& b, const Image& reference) {
    if (a.width() != reference.width() || a.height() != reference.height()) {
        throw tukor::Error("pictures of different sizes");
    }
    Errors sum;
    for (std::size_t i = 0; i < reference.pixels().size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const float r = reference.pixels()[i][c];
            const float x = a.pixels()[i][c], y = b.pixels()[i][c];
            const double product = static_cast<double>(x - r) * static_cast<double>(y - r);
            sum.squares += product;
            sum.relative += product / static_cast<double>(r * r + kDark * kDark);
            sum.codes += static_cast<double>(codeOf(x) - codeOf(r)) *
                         static_cast<double>(codeOf(y) - codeOf(r));
        }
    }
    const double count = 3.0 * static_cast<double>(reference.pixels().size());
    return {sum.squares / count, sum.relative / count, sum.codes / count};
}

double root(double product) {
    return std::copysign(std::sqrt(std::fabs(product)), product);
}

void print(const Errors& errors) {
    std::printf("%.6g %.6g %.6g\n", root(errors.squares), errors.relative, root(errors.codes));
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc < 3) {
            std::fprintf(stderr, "usage: picture_error REFERENCE1 REFERENCE2 [PICTURE...]\n");
            return 2;
        }
        const Image first = tukor::loadImage(argv[1]);
        Image reference = tukor::loadImage(argv[2]);
        if (first.width() != reference.width() || first.height() != reference.height()) {
            throw tukor::Error("references of different sizes");
        }
        for (std::size_t i = 0; i < reference.pixels().size(); ++i) {
            reference.pixels()[i] = 0.5f * (reference.pixels()[i] + first.pixels()[i]);
        }
        print(products(first, first, reference));
        std::vector<Image> pictures;
        for (int i = 3; i < argc; ++i) {
            pictures.push_back(tukor::loadImage(argv[i]));
            print(products(pictures.back(), pictures.back(), reference));
        }
        if (pictures.size() > 1) print(products(pictures[0], pictures[1], reference));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "picture_error: %s\n", error.what());
        return 1;
    }
}
