// Orthonormal associated Legendre functions of one order, degree after degree.
#pragma once
#include <cmath>
#include <numbers>
#include <vector>

namespace tukor {

/// P_l+1 = rise[l + 1] x P_l - fall[l + 1] P_l-1, starting from P_m = first(sin theta), P_m-1 = 0.
class LegendreOrder {
public:
    LegendreOrder(int order, int degree)
        : rise(static_cast<std::size_t>(degree) + 2, 0.0), fall(rise), order_(order) {
        const double m2 = static_cast<double>(order) * order;
        const auto ratio = [&](double l) { return std::sqrt((4 * l * l - 1) / (l * l - m2)); };
        for (int l = order + 1; l <= degree + 1; ++l) {
            rise[static_cast<std::size_t>(l)] = ratio(l);
            fall[static_cast<std::size_t>(l)] = l > order + 1 ? ratio(l) / ratio(l - 1) : 0.0;
        }
        logFactor_ = -0.5 * std::log(4 * std::numbers::pi);
        for (int k = 1; k <= order; ++k) logFactor_ += 0.5 * std::log((2.0 * k + 1) / (2.0 * k));
    }

    /// P_m at sin theta; 0 where it and all that follows up to kMaxDegree is negligible.
    [[nodiscard]] double first(double sinTheta) const noexcept {
        const double exponent = logFactor_ + order_ * std::log(sinTheta);
        return exponent < -650.0 ? 0.0 : std::exp(exponent);
    }

    std::vector<double> rise;
    std::vector<double> fall;

private:
    int order_;
    double logFactor_;
};

}  // namespace tukor
