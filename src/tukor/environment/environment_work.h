// Environments on their way from file to file: what `tukor environment` does.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tukor/base/progress.h"
#include "tukor/environment/clipping.h"
#include "tukor/environment/cube_map.h"
#include "tukor/environment/orientation.h"
#include "tukor/image/image_file.h"
#include "tukor/image/texture_file.h"

namespace tukor {

enum class PictureForm { equirect, faces, hcross, vcross, hstrip, vstrip, octahedral, ball };

/// An environment in the form that it came in, so that what need not be resampled is not. One of
/// the two is there, or both; their axes are this project's.
struct WorkSource {
    std::string layout;  // in words
    int width = 0;       // of the picture, or of one of six
    int height = 0;
    std::optional<Image> panorama;
    std::optional<CubeMap> cube;
    std::optional<Image> square;  // the octahedral or ball picture of which `cube` was made
    bool ball = false;
    std::vector<std::string> warnings;
};

/// From all that loadEnvironment takes, and octahedral and ball pictures when said so; `from` says
/// how panoramas and cube maps are oriented. Throws Error, for what is built in and not `opengl`
/// too.
[[nodiscard]] WorkSource loadWorkSource(const std::string& nameOrPath,
                                        std::optional<PictureForm> form,
                                        Orientation from = Orientation::opengl);

/// Turned about +Y, counter-clockwise seen from above.
void turn(WorkSource& source, double radians);

/// Each stop doubles the radiance.
void expose(WorkSource& source, float stops);

/// The panorama, made from the cube map if need be.
[[nodiscard]] const Image& panoramaOf(WorkSource& source);
[[nodiscard]] Image panoramaOf(WorkSource&& source);

/// What an environment is written as.
struct WorkTarget {
    PictureForm form = PictureForm::equirect;
    /// The width of a panorama or else the edge of a face or picture; none: the source's detail.
    std::optional<int> size = std::nullopt;
    /// Of panoramas and cube maps; octahedral and ball pictures have their own.
    Orientation to = Orientation::opengl;
    SaveOptions picture = {};
    TextureOptions texture = {};
};

/// Throws the Error that saveWork would for a path that does not suit the form.
void checkWorkTarget(const std::string& path, PictureForm form);

/// A file that is to be written.
struct EncodedFile {
    std::string path;
    std::vector<std::byte> bytes;
    Clipping clipping = {};  // of the first level
};

/// The files of an environment, none of them written yet; a texture file takes a cube map and all
/// its levels. None where `progress` asked to stop. Throws Error.
[[nodiscard]] std::vector<EncodedFile> encodeWork(const std::string& path, WorkSource source,
                                                  const WorkTarget& target,
                                                  const Progress& progress = {});

/// The file of all levels of a chain. None where `progress` asked to stop. Throws Error.
[[nodiscard]] std::vector<EncodedFile> encodeLevels(const std::string& path,
                                                    std::span<const CubeMap> levels,
                                                    const WorkTarget& target = {},
                                                    const Progress& progress = {});

void writeFiles(std::span<const EncodedFile> files);

/// encodeWork, written. False, and nothing is written, where `progress` asked to stop.
bool saveWork(const std::string& path, WorkSource source, const WorkTarget& target,
              const Progress& progress = {});

}  // namespace tukor
