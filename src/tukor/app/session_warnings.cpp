// What a session's files and options ask for and do not get.
#include <algorithm>

#include "tukor/app/session.h"
#include "tukor/scene/assign_materials.h"

namespace tukor {

std::vector<std::string> Session::warnings() const {
    std::vector<std::string> all = scene_.warnings;
    if (options_.quality.fidelity != Fidelity::single) {  // a single look-up needs no inside
        const std::vector<std::string> open = closednessWarnings(scene_);
        all.insert(all.end(), open.begin(), open.end());
    }
    const bool single = options_.quality.fidelity == Fidelity::single;
    const bool plain = std::any_of(scene_.parts.begin(), scene_.parts.end(), [&](const Part& part) {
        return part.material.dispersion > 0.0f && (single || part.material.finish);
    });
    if (single && !options_.light.ground.empty() && lookUps_ == LookUps::cube)
        all.emplace_back("gl draws no ground at --fidelity single; --renderer trace does");
    if (plain && lookUps_ == LookUps::cube)  // gl's
        all.emplace_back(
            "gl draws dispersion of smooth surfaces at --fidelity double and exact alone; "
            "--renderer trace shows all");
    const bool frosted = std::any_of(scene_.parts.begin(), scene_.parts.end(), [](const Part& p) {
        return p.material.finish && p.material.kind == MaterialKind::dielectric;
    });
    if (frosted && lookUps_ == LookUps::cube)
        all.emplace_back(
            "gl refracts light in rough glass once, absorbs none and shows nothing behind it but "
            "the environment; --renderer trace shows all");
    if (options_.camera.focus && !(options_.camera.aperture > 0.0f))
        all.emplace_back("--focus says nothing without --aperture: all is sharp");
    if (options_.camera.aperture > 0.0f && lookUps_ == LookUps::cube)
        all.emplace_back(
            "gl draws all sharp, whatever the --aperture; --renderer trace blurs what is out of "
            "focus");
    for (const std::string& warning : environment_->warnings) {
        all.push_back(environment_->name + ": " + warning);
    }
    return all;
}

}  // namespace tukor
