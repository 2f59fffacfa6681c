// Which extensions of glTF are read, which are passed over with a note, and which are refused.
#pragma once
#include "tukor/scene/json_item.h"
#include "tukor/scene/model_file.h"
#include "tukor/scene/notes.h"

namespace tukor {

/// Throws Error where `extensionsRequired` names one without which the file's shapes cannot be
/// read.
void refuseUnknownExtensions(const JsonItem& root);

/// Notes the other extensions of `extensionsUsed` that change the picture and are not rendered, and
/// what waits for an option.
void noteFeatures(const JsonItem& root, const ModelOptions& options, Notes& notes);

}  // namespace tukor
