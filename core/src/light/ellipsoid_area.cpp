#include "light/ellipsoid_area.h"

#include <array>
#include <cmath>

#include "math/constants.h"
#include "math/vec.h"

namespace etendue {
namespace {

using Symmetric = std::array<std::array<double, 3>, 3>;

/// One rotation of Jacobi's method: makes a[p][q] zero.
void rotate(Symmetric& a, std::size_t p, std::size_t q) {
    if (a[p][q] == 0) return;
    const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
    const double c = 1 / std::hypot(t, 1.0);
    const double s = t * c;
    const std::size_t r = 3 - p - q;
    const double off = a[p][q];
    const double a_rp = a[r][p];
    const double a_rq = a[r][q];
    a[p][p] -= t * off;
    a[q][q] += t * off;
    a[p][q] = a[q][p] = 0;
    a[r][p] = a[p][r] = c * a_rp - s * a_rq;
    a[r][q] = a[q][r] = s * a_rp + c * a_rq;
}

std::array<double, 3> eigenvalues(Symmetric a) {
    constexpr int kSweeps = 12;  // convergence is quadratic: six sweeps reach double precision
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        rotate(a, 0, 1);
        rotate(a, 0, 2);
        rotate(a, 1, 2);
    }
    return {a[0][0], a[1][1], a[2][2]};
}

/// Carlson's symmetric integrals R_F and R_D by duplication (Carlson 1979; DLMF 19.36). R_D is symmetric in x, y only.
struct CarlsonIntegrals {
    double r_f;
    double r_d;
};

CarlsonIntegrals carlson(double x, double y, double z) {
    double sum = 0;
    double factor = 1;
    constexpr int kDuplications = 40;  // each brings the arguments four times closer together
    for (int i = 0; i < kDuplications; ++i) {
        const double lambda = std::sqrt(x * y) + std::sqrt(y * z) + std::sqrt(z * x);
        sum += factor / (std::sqrt(z) * (z + lambda));
        factor /= 4;
        x = (x + lambda) / 4;
        y = (y + lambda) / 4;
        z = (z + lambda) / 4;
    }
    return {1 / std::sqrt(x), 3 * sum + factor / (x * std::sqrt(x))};
}

/// R_G(x, y, z): the mean of sqrt(x n_x^2 + y n_y^2 + z n_z^2) over the unit sphere (DLMF 19.16.3, 19.21.10).
double carlson_r_g(double x, double y, double z) {
    const CarlsonIntegrals r = carlson(x, y, z);
    return (z * r.r_f - (x - z) * (y - z) * r.r_d / 3 + std::sqrt(x * y / z)) / 2;
}

}  // namespace

double ellipsoid_area(const Transform& world_from_object) {
    // dA = |det M| |M^-T n| dA_object: the area is 4 pi times the mean of |C n|, C = det M M^-T the cofactor matrix.
    const double det = world_from_object.determinant();
    const std::array<Vec3, 3> columns{world_from_object.normal({1, 0, 0}) * det,
                                      world_from_object.normal({0, 1, 0}) * det,
                                      world_from_object.normal({0, 0, 1}) * det};
    Symmetric c_t_c{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) c_t_c[i][j] = dot(columns[i], columns[j]);
    }
    // The identity for R_G loses no digits when z lies between x and y.
    std::array<double, 3> e = eigenvalues(c_t_c);
    std::sort(e.begin(), e.end());
    return 4 * kPi * carlson_r_g(std::max(e[0], 0.0), e[2], e[1]);
}

}  // namespace etendue
