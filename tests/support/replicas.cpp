#include "support/replicas.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/students_t.hpp>

#include <etendue/render_session.h>

#include "support/estimate.h"

namespace etendue::test {
namespace {

struct Moments {
    double mean = 0;
    double variance_of_mean = 0;
};

Moments pixel_moments(const Replicas& r, std::size_t pixel) {
    Estimate estimate;
    for (const auto& image : r.images) estimate.add(image[pixel]);
    return {estimate.mean(), estimate.standard_error() * estimate.standard_error()};
}

double two_sided_p(double t, double degrees) {
    if (!std::isfinite(t)) return 0;
    return 2 * boost::math::cdf(boost::math::complement(boost::math::students_t(degrees), std::abs(t)));
}

/// Welch's test; equal constants agree, different constants do not.
double welch_p(const Moments& a, const Moments& b, double na, double nb) {
    const double variance = a.variance_of_mean + b.variance_of_mean;
    const double rounding = 1e-6 * std::max(std::abs(a.mean), std::abs(b.mean));  // images are stored as float
    if (std::abs(a.mean - b.mean) <= rounding) return 1;
    if (variance == 0) return 0;
    const double degrees =
        variance * variance /
        (a.variance_of_mean * a.variance_of_mean / (na - 1) + b.variance_of_mean * b.variance_of_mean / (nb - 1));
    return two_sided_p((a.mean - b.mean) / std::sqrt(variance), degrees);
}

struct Worst {
    double p = 1;
    std::string where;
};

void compare(const Replicas& a, const Replicas& b, const std::string& what, double tests, Worst& worst) {
    const std::size_t cells = a.images[0].size();
    for (std::size_t i = 0; i < cells; ++i) {
        const Moments ma = pixel_moments(a, i);
        const Moments mb = pixel_moments(b, i);
        const double p =
            std::min(1.0, welch_p(ma, mb, static_cast<double>(a.images.size()), static_cast<double>(b.images.size())) *
                              static_cast<double>(cells) * tests);
        if (p >= worst.p) continue;
        worst.p = p;
        worst.where = what + " " + std::to_string(i) + ": " + std::to_string(ma.mean) + " and " +
                      std::to_string(mb.mean) + ", ratio " + std::to_string(ma.mean / mb.mean);
    }
}

Worst worst_difference(const Replicas& a, const Replicas& b) {
    constexpr double kTests = 3;
    Worst worst;
    compare(a, b, "pixel", kTests, worst);
    compare(a.blocks(4), b.blocks(4), "block", kTests, worst);
    const int whole = std::max(a.width, a.height);
    compare(a.blocks(whole), b.blocks(whole), "image", kTests, worst);
    return worst;
}

}  // namespace

Replicas Replicas::blocks(int block) const {
    Replicas out;
    if (second_look) out.second_look = [look = second_look, block] { return look().blocks(block); };
    out.width = (width + block - 1) / block;
    out.height = (height + block - 1) / block;
    out.invalid = invalid;
    for (const auto& image : images) {
        std::vector<double> sums(static_cast<std::size_t>(out.width * out.height));
        std::vector<int> counts(sums.size());
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const auto cell = static_cast<std::size_t>((y / block) * out.width + x / block);
                sums[cell] += image[static_cast<std::size_t>(y * width + x)];
                ++counts[cell];
            }
        }
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i];
        out.images.push_back(sums);
    }
    return out;
}

Replicas Replicas::cut(const PixelWindow& window) const {
    Replicas out;
    if (second_look) out.second_look = [look = second_look, window] { return look().cut(window); };
    out.width = window.x1 - window.x0;
    out.height = window.y1 - window.y0;
    out.invalid = invalid;
    for (const auto& image : images) {
        std::vector<double>& pixels = out.images.emplace_back();
        for (int y = window.y0; y < window.y1; ++y) {
            for (int x = window.x0; x < window.x1; ++x) {
                pixels.push_back(image[static_cast<std::size_t>(y * width + x)]);
            }
        }
    }
    return out;
}

double Replicas::mean() const { return pixel_moments(blocks(std::max(width, height)), 0).mean; }

double Replicas::standard_error() const {
    return std::sqrt(pixel_moments(blocks(std::max(width, height)), 0).variance_of_mean);
}

double Replicas::mean_pixel_variance() const {
    double sum = 0;
    for (std::size_t i = 0; i < images[0].size(); ++i) sum += pixel_moments(*this, i).variance_of_mean;
    return sum / static_cast<double>(images[0].size()) * static_cast<double>(images.size());
}

RenderedImage render(const SceneDescription& scene, const RenderSettings& settings) {
    RenderSession session(scene, settings);
    session.start();
    session.wait();
    return session.snapshot();
}

Replicas render_replicas(const SceneDescription& scene, RenderSettings settings, int count, std::uint64_t stream) {
    constexpr std::uint64_t kSecondStream = 1ULL << 31;
    constexpr int kSecondSamples = 4;
    Replicas out;
    out.second_look = [scene, settings, count, stream] {
        RenderSettings longer = settings;
        longer.samples_per_pixel *= kSecondSamples;
        return render_replicas(scene, longer, count, stream ^ kSecondStream);
    };
    settings.samples_per_pixel = std::max(1, samples(100 * settings.samples_per_pixel) / 100);
    settings.threads = 1;  // such small pictures give no more than one anything to do
    for (int i = 0; i < count; ++i) {
        settings.seed = (stream << 32) + static_cast<std::uint64_t>(i);
        const RenderedImage image = render(scene, settings);
        out.width = image.width;
        out.height = image.height;
        for (std::uint64_t n : image.statistics.invalid) out.invalid += n;
        const std::vector<float>& rgb = image.find(Aov::Color)->data;
        std::vector<double>& luminances = out.images.emplace_back();
        for (std::size_t p = 0; p < rgb.size(); p += 3) {
            luminances.push_back(0.2126 * rgb[p] + 0.7152 * rgb[p + 1] + 0.0722 * rgb[p + 2]);
        }
    }
    return out;
}

RenderSettings small_settings(IntegratorKind integrator, int size, int samples_per_pixel) {
    RenderSettings settings;
    settings.integrator = integrator;
    settings.width = size;
    settings.height = size;
    settings.samples_per_pixel = samples_per_pixel;
    settings.light_paths_per_pixel = 2;
    settings.aovs = {Aov::Color};
    return settings;
}

testing::AssertionResult same_picture(const Replicas& a, const Replicas& b, double resolution) {
    if (a.invalid + b.invalid > 0) {
        return testing::AssertionFailure() << a.invalid + b.invalid << " invalid contributions";
    }
    if (!full_effort()) return testing::AssertionSuccess();
    const Worst worst = worst_difference(a, b);
    if (worst.p < kFalseAlarm && a.second_look && b.second_look) {
        Replicas longer = a.second_look();
        longer.second_look = {};
        return same_picture(longer, b.second_look(), resolution);
    }
    if (worst.p < kFalseAlarm) return testing::AssertionFailure() << "p = " << worst.p << " at " << worst.where;
    const double error = std::hypot(a.standard_error(), b.standard_error());
    if (error > resolution * std::abs(a.mean())) {
        return testing::AssertionFailure()
               << "standard error " << error << " of the difference is too large for " << a.mean();
    }
    return testing::AssertionSuccess() << "p = " << worst.p << " at " << worst.where;
}

testing::AssertionResult mean_is(const Replicas& a, double expected, double resolution) {
    if (a.invalid > 0) return testing::AssertionFailure() << a.invalid << " invalid contributions";
    if (!full_effort()) return testing::AssertionSuccess();
    const double error = a.standard_error();
    const double rounding = 1e-6 * std::abs(expected);
    const double off = std::max(0.0, std::abs(a.mean() - expected) - rounding);
    const double p = off == 0 ? 1 : two_sided_p(off / error, static_cast<double>(a.images.size()) - 1);
    if (p < kFalseAlarm) {
        return testing::AssertionFailure() << "mean " << a.mean() << " +- " << error << ", expected " << expected
                                           << ", ratio " << a.mean() / expected << ", p = " << p;
    }
    if (error > resolution * std::abs(expected)) {
        return testing::AssertionFailure() << "standard error " << error << " is too large for " << expected;
    }
    return testing::AssertionSuccess();
}

}  // namespace etendue::test
