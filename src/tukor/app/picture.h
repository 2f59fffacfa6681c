// From a session to a file: renders with the renderer that the options choose, develops, saves.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tukor/app/session.h"
#include "tukor/scene/render_options.h"

namespace tukor {

/// The one that pictures come from: trace, unless the options or the build say otherwise.
[[nodiscard]] Renderer rendererFor(const SessionOptions& options) noexcept;

/// The options whose command gives what a window shows: by gl, without what only trace can do.
[[nodiscard]] SessionOptions windowOptions(SessionOptions options);

/// What of the options a window cannot do, one sentence each.
[[nodiscard]] std::vector<std::string> unusedInWindow(const SessionOptions& options);

/// Throws Error unless `out` has the extension of a picture format that holds what the options ask
/// for, and lies in a folder that can be written to: asked before the work, not after it.
void requireWritablePicture(const std::filesystem::path& out, const SessionOptions& options);

/// What of the options the format of `out` does not hold, one sentence each: the picture is as good
/// without, so that one set of options can serve several files.
[[nodiscard]] std::vector<std::string> unusedInFile(const std::filesystem::path& out,
                                                    const SessionOptions& options);

/// `tukor-0001.png` or the first number after it that the folder does not have yet.
[[nodiscard]] std::filesystem::path freshPicturePath(const std::filesystem::path& folder);

/// Whether what is brighter than white tells in the file that savePicture writes.
[[nodiscard]] bool showsBeyondWhite(const std::filesystem::path& out,
                                    const SessionOptions& options);

/// Throws Error when this build lacks the renderer, or it cannot work here. When `progress` asks to
/// stop, the picture so far. `beyondWhite` as in RenderOptions.
[[nodiscard]] Rendering renderPicture(const Session& session, const RenderProgress& progress = {},
                                      bool beyondWhite = true);

/// Tone mapped and sRGB for .png and .jpg, linear radiance for .exr and .hdr; the command line that
/// gives the picture, all options and the program's version go into its metadata.
void savePicture(const std::filesystem::path& out, const Rendering& rendering,
                 const SessionOptions& options);

/// What a person should know about how the picture came about, one sentence each.
[[nodiscard]] std::vector<std::string> warningsOf(const Rendering& rendering,
                                                  const Session& session);

/// What the file that savePicture writes cuts off the radiance, as a sentence; empty where nothing.
[[nodiscard]] std::string clippedInFile(const std::filesystem::path& out,
                                        const Rendering& rendering, const SessionOptions& options);

/// Time, samples, rays and error of a picture in a line.
[[nodiscard]] std::string summaryOf(const Rendering& rendering, double seconds);

}  // namespace tukor
