// What `tukor environment` is asked to do, and doing it.
#pragma once
#include <optional>
#include <string>

#include "tukor/app/options.h"
#include "tukor/environment/environment_work.h"
#include "tukor/environment/harmonics.h"
#include "tukor/environment/prefilter.h"

namespace tukor {

/// How what is read is laid out.
struct LayoutArguments {
    std::optional<PictureForm> inLayout;
};

/// What is read, and how it is turned.
struct SourceArguments {
    std::string in;
    LayoutArguments layout;
    Orientation from = Orientation::opengl;
    float rotateDegrees = 0.0f;
    std::string sun;
};

/// What is written.
struct TargetArguments {
    std::string out;
    std::optional<PictureForm> layout;
    std::optional<int> size;
    Orientation to = Orientation::opengl;
    std::optional<TexelFormat> format;  // none: the file type's own
    Supercompression compression = Supercompression::none;
};

enum class FilterKind { ggx, charlie, irradiance, blur, sh, brdf };
enum class Quantity { radiance, irradiance };

struct FilterArguments {
    FilterKind kind = FilterKind::ggx;
    int levels = 5;
    RoughnessScale scale = RoughnessScale::filament;
    float blurDegrees = 5.0f;
    int bands = 3;
    HarmonicWindow window = HarmonicWindow::none;
    Quantity quantity = Quantity::radiance;
};

struct InfoArguments {
    std::string thumbnail;
    bool json = false;
};

/// Exit statuses. They throw Error.
int convertEnvironment(const SourceArguments& from, const TargetArguments& to,
                       const DevelopOptions& develop);
int filterEnvironment(const SourceArguments& from, const TargetArguments& to,
                      const FilterArguments& arguments, const DevelopOptions& develop);
int describeEnvironment(const SourceArguments& from, const InfoArguments& arguments);

}  // namespace tukor
