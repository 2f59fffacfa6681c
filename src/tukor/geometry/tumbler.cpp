#include "tukor/geometry/tumbler.h"

#include <algorithm>
#include <cmath>

#include "tukor/geometry/revolution.h"

namespace tukor {

namespace {

using glm::dvec2;

constexpr int kSides = 256;     // the outline is within 6e-5 of the circle
constexpr int kArcSteps = 16;   // per quarter circle
constexpr int kLineSteps = 12;  // keeps triangles of the long walls from being needles

// Corners of the glass in (r, y): a conical wall 5 cm thick on a base of 30 cm, a round rim.
constexpr dvec2 kFoot(0.58, -1.0);
constexpr dvec2 kRimOutside(0.74, 1.0);
constexpr dvec2 kRimInside(0.69, 1.0);
constexpr dvec2 kFloor(0.535, -0.7);
constexpr double kRimFillet = 0.0225;
constexpr double kFloorFillet = 0.12;

constexpr double kWaterHeight = 0.45;  // where it touches the glass
constexpr double kOverlap = 0.02;      // into the wall

dvec2 contactPoint() {
    const double t = (kWaterHeight - kFloor.y) / (kRimInside.y - kFloor.y);
    return dvec2(glm::mix(kFloor.x, kRimInside.x, t), kWaterHeight);
}

// From the foot's centre over the rim to where the water touches; and on to the floor's centre.
Profile dryProfile() {
    const OutlineCorner outline[] = {{dvec2(0.0, kFoot.y)},
                                     {kFoot, 0.05},
                                     {kRimOutside, kRimFillet},
                                     {kRimInside, kRimFillet},
                                     {contactPoint()}};
    return profileFromOutline(outline, kArcSteps, kLineSteps);
}

Profile wetProfile() {
    const OutlineCorner outline[] = {
        {contactPoint()}, {kFloor, kFloorFillet}, {dvec2(0.0, kFloor.y)}};
    return profileFromOutline(outline, kArcSteps, kLineSteps);
}

// The water's surface from the glass to the axis: it climbs the wall as water does, by 2 cm.
Profile surfaceProfile() {
    constexpr double climb = 0.02, reach = 0.05;
    constexpr int steps = 48;
    const dvec2 contact = contactPoint();
    Profile profile;
    for (int i = 0; i <= steps; ++i) {
        // Closer together at the wall, where the surface bends.
        const double t = 1.0 - static_cast<double>(i) / steps;
        const double r = contact.x * t * (2.0 - t);
        const double rise = climb * std::exp((r - contact.x) / reach);
        const double slope = i == steps ? 0.0 : rise / reach;
        profile.push_back({dvec2(r, contact.y - climb + rise), glm::normalize(dvec2(-slope, 1.0))});
    }
    profile.front().position = contact;
    return profile;
}

}  // namespace

Tumbler makeTumbler() {
    Tumbler tumbler;
    Profile glass = dryProfile();
    append(glass, wetProfile());
    tumbler.glass = revolve(glass, kSides);

    // Below and beside its surface the water is the bowl, grown by the overlap.
    const Profile surface = surfaceProfile();
    const dvec2 slope(surface.front().normal.y, -surface.front().normal.x);
    const dvec2 wall = glm::normalize(kRimInside - kFloor);
    const dvec2 outward(wall.y, -wall.x);
    const dvec2 top = surface.front().position + kOverlap / glm::dot(slope, outward) * slope;
    // The corner of the grown bowl: on its wall's line, at its floor's height.
    const double floor = kFloor.y - kOverlap;
    const dvec2 corner = top + (floor - top.y) / wall.y * wall;
    const OutlineCorner outline[] = {
        {dvec2(0.0, floor)}, {corner, kFloorFillet + kOverlap}, {top}, {surface.front().position}};
    Profile water = profileFromOutline(outline, kArcSteps, kLineSteps);
    append(water, surface);
    tumbler.water = revolve(water, kSides);
    return tumbler;
}

std::vector<MediumInterface> makeTumblerInterfaces() {
    return {{"", "glass", revolve(dryProfile(), kSides)},
            {"water", "glass", revolve(wetProfile(), kSides)},
            {"", "water", revolve(surfaceProfile(), kSides)}};
}

Mesh makeWineGlass() {
    const OutlineCorner outline[] = {
        {dvec2(0.0, -1.0)},          {dvec2(0.50, -1.0), 0.012}, {dvec2(0.50, -0.965), 0.012},
        {dvec2(0.06, -0.90), 0.12},  {dvec2(0.05, -0.10), 0.20}, {dvec2(0.56, 0.15), 0.42},
        {dvec2(0.44, 1.0), 0.011},   {dvec2(0.415, 1.0), 0.011}, {dvec2(0.532, 0.173), 0.392},
        {dvec2(0.08, -0.025), 0.15}, {dvec2(0.0, -0.025)},
    };
    std::vector<OutlineCorner> corners(std::begin(outline), std::end(outline));
    return revolve(profileFromOutline(corners, kArcSteps, kLineSteps), kSides);
}

}  // namespace tukor
