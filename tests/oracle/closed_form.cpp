#include "oracle/closed_form.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <utility>

#include "tukor/base/parallel.h"

namespace tukor::oracle {

namespace {

using glm::dvec3;

/// Where a ray from outside first meets a sphere.
struct Hit {
    dvec3 normal;  // outward
    double cosThetaI;
};

std::optional<Hit> meet(dvec3 eye, dvec3 direction, const Sphere& sphere) {
    const dvec3 from = eye - sphere.centre;
    const double b = glm::dot(from, direction);
    const dvec3 nearest = from - b * direction;  // of the ray to the centre
    const double d2 = sphere.radius * sphere.radius - glm::dot(nearest, nearest);
    if (d2 <= 0.0 || -b - std::sqrt(d2) <= 0.0) return std::nullopt;
    const dvec3 normal = (nearest - std::sqrt(d2) * direction) / sphere.radius;
    return Hit{normal, std::min(-glm::dot(direction, normal), 1.0)};
}

dvec3 look(const Environment& environment, dvec3 direction) {
    return environment(glm::vec3(direction));
}

dvec3 reflected(dvec3 direction, dvec3 normal) {
    return direction - 2.0 * glm::dot(direction, normal) * normal;
}

double schlick(double cosThetaI, double R0) {
    return R0 + (1.0 - R0) * std::pow(1.0 - cosThetaI, 5.0);
}

double reflectance(double cosThetaI, double eta, double k, FresnelForm form) {
    if (form == FresnelForm::exact) return fresnel(cosThetaI, eta, k);
    const double R0 = ((eta - 1.0) * (eta - 1.0) + k * k) / ((eta + 1.0) * (eta + 1.0) + k * k);
    return schlick(cosThetaI, R0);
}

dvec3 reflectance(const Material& material, double cosThetaI, FresnelForm form) {
    if (material.kind == MaterialKind::mirror) return dvec3(material.tint);
    dvec3 R(0.0);
    for (int channel = 0; channel < 3; ++channel) {
        R[channel] = reflectance(cosThetaI, material.eta[channel], material.k[channel], form);
    }
    return R;
}

/// Into a denser or thinner sphere from outside; none at total reflection.
std::optional<dvec3> refracted(dvec3 direction, const Hit& hit, double eta) {
    const double cos2ThetaT = 1.0 - (1.0 - hit.cosThetaI * hit.cosThetaI) / (eta * eta);
    if (cos2ThetaT <= 0.0) return std::nullopt;
    const dvec3 parallel = direction + hit.cosThetaI * hit.normal;
    return glm::normalize(parallel / eta - std::sqrt(cos2ThetaT) * hit.normal);
}

}  // namespace

double fresnel(double cosThetaI, double eta, double k) {
    const std::complex<double> index2 = std::complex<double>(eta, k) * std::complex<double>(eta, k);
    const std::complex<double> g = std::sqrt(index2 - (1.0 - cosThetaI * cosThetaI));
    if (k == 0.0 && g.real() == 0.0) return 1.0;
    const std::complex<double> rs = (cosThetaI - g) / (cosThetaI + g);
    const std::complex<double> rp = (index2 * cosThetaI - g) / (index2 * cosThetaI + g);
    return 0.5 * (std::norm(rs) + std::norm(rp));
}

View background(Environment environment) {
    return [environment = std::move(environment)](dvec3, dvec3 direction) {
        return look(environment, direction);
    };
}

View reflectingSphere(const Material& material, Environment environment, FresnelForm form,
                      Sphere sphere) {
    return [=, environment = std::move(environment)](dvec3 eye, dvec3 direction) {
        const std::optional<Hit> hit = meet(eye, direction, sphere);
        if (!hit) return look(environment, direction);
        return reflectance(material, hit->cosThetaI, form) *
               look(environment, reflected(direction, hit->normal));
    };
}

View singleInterfaceSphere(const Material& material, Environment environment, FresnelForm form,
                           Sphere sphere) {
    return [=, environment = std::move(environment)](dvec3 eye, dvec3 direction) {
        const std::optional<Hit> hit = meet(eye, direction, sphere);
        if (!hit) return look(environment, direction);
        const double eta = material.eta.x;
        const dvec3 mirrored = look(environment, reflected(direction, hit->normal));
        const std::optional<dvec3> through = refracted(direction, *hit, eta);
        if (!through) return mirrored;
        const double R = reflectance(hit->cosThetaI, eta, 0.0, form);
        return R * mirrored + (1.0 - R) * look(environment, *through);
    };
}

View solidSphere(const Material& material, Environment environment, Sphere sphere) {
    return [=, environment = std::move(environment)](dvec3 eye, dvec3 direction) {
        const std::optional<Hit> hit = meet(eye, direction, sphere);
        if (!hit) return look(environment, direction);
        const double eta = material.eta.x;
        dvec3 L(0.0);
        const dvec3 mirrored = look(environment, reflected(direction, hit->normal));
        const std::optional<dvec3> entered = refracted(direction, *hit, eta);
        if (!entered) return mirrored;
        const double R = fresnel(hit->cosThetaI, eta, 0.0);
        L += R * mirrored;
        const double cosInside = -glm::dot(*entered, hit->normal);
        const dvec3 chord = glm::exp(-dvec3(material.sigmaA) * (2.0 * sphere.radius * cosInside));
        dvec3 weight(1.0 - R);
        dvec3 inside = *entered;
        dvec3 normal = hit->normal;
        constexpr double kNegligible = 1e-6;
        for (;;) {
            // Across the sphere: the far end's outward normal, by symmetry of the chord.
            normal += 2.0 * cosInside * inside;
            normal = glm::normalize(normal);
            weight *= chord;
            const dvec3 parallel = inside - cosInside * normal;
            const dvec3 out = glm::normalize(eta * parallel + hit->cosThetaI * normal);
            const dvec3 remaining = R * weight;
            if (std::max({remaining.x, remaining.y, remaining.z}) < kNegligible) {
                return L + weight * look(environment, out);
            }
            L += (1.0 - R) * weight * look(environment, out);
            weight = remaining;
            inside = reflected(inside, normal);
        }
    };
}

Image picture(const Camera& camera, int width, int height, int samples, const View& view) {
    Image image(width, height);
    const CameraAxes axes = axesOf(camera);
    const double halfHeight = std::tan(0.5 * static_cast<double>(camera.verticalFov));
    const double perPixel = 2.0 * halfHeight / height;
    parallelFor(0, height, 1, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            for (int column = 0; column < width; ++column) {
                dvec3 sum(0.0);
                for (int i = 0; i < samples * samples; ++i) {
                    const double x = column + (i % samples + 0.5) / samples - 0.5 * width;
                    const double y = 0.5 * height - row - (i / samples + 0.5) / samples;
                    const dvec3 direction = dvec3(axes.forward) +
                                            (x * perPixel) * dvec3(axes.right) +
                                            (y * perPixel) * dvec3(axes.up);
                    sum += view(dvec3(camera.eye), glm::normalize(direction));
                }
                image.at(column, row) = glm::vec3(sum / static_cast<double>(samples * samples));
            }
        }
    });
    return image;
}

}  // namespace tukor::oracle
