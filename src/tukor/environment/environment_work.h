// Environments on their way from file to file: what `tukor environment` does.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tukor/environment/brdf_table.h"
#include "tukor/environment/harmonics.h"
#include "tukor/environment/panorama.h"
#include "tukor/environment/prefilter.h"
#include "tukor/environment/sun.h"
#include "tukor/image/image_file.h"
#include "tukor/image/texture_file.h"

namespace tukor {

enum class PictureForm { equirect, faces, hcross, vcross, hstrip, vstrip, octahedral, ball };

/// An environment in the form that it came in, so that what need not be resampled is not. One of
/// the two is there, or both.
struct WorkSource {
    std::string layout;  // in words
    int width = 0;       // of the picture, or of one of six
    int height = 0;
    std::optional<Image> panorama;
    std::optional<CubeMap> cube;
    std::vector<std::string> warnings;
};

/// From all that loadEnvironment takes, and octahedral and ball pictures when said so. Throws
/// Error.
[[nodiscard]] WorkSource loadWorkSource(const std::string& nameOrPath,
                                        std::optional<PictureForm> form);

/// Turned about +Y, counter-clockwise seen from above.
void turn(WorkSource& source, double radians);

/// The panorama, made from the cube map if need be.
[[nodiscard]] const Image& panoramaOf(WorkSource& source);
[[nodiscard]] Image panoramaOf(WorkSource&& source);

/// Throws the Error that saveWork would for a path that does not suit the form.
void checkWorkTarget(const std::string& path, PictureForm form);

/// Writes in the given form; `size` is the width of a panorama or else the edge of a face or
/// picture; none keeps the detail of the source. A texture file takes a cube map and all its
/// levels.
void saveWork(const std::string& path, WorkSource& source, PictureForm form,
              std::optional<int> size, const SaveOptions& options,
              const TextureOptions& textureOptions = {});

/// All levels of a chain in one texture file. Throws Error.
void saveLevels(const std::string& path, std::span<const CubeMap> levels,
                const TextureOptions& options = {});

/// Lines of text: layout, size, range, mean, repairs, sun, harmonics.
[[nodiscard]] std::string describeWork(WorkSource source);

/// Three exposures, two stops apart around the mean, and the six faces.
[[nodiscard]] Image contactSheet(WorkSource source);

}  // namespace tukor
