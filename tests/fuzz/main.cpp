// Random scenes at the edges of everything: see README.md.

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "core/io/temporary_directory.h"
#include "fuzz/dice.h"
#include "fuzz/run_trial.h"
#include "fuzz/supervisor.h"
#include "fuzz/trial.h"
#include "support/hdr_file.h"

namespace etendue::test {
namespace {

constexpr const char* kUsage =
    "fuzz --seed=N                  one scene, in this process\n"
    "fuzz --bytes=FILE              one scene, by the bytes of a file\n"
    "fuzz --count=N [--from=M]      seeds M (0) to M + N\n"
    "fuzz --seconds=S [--from=M]    as many as S seconds of CPU time allow\n";

/// One image for all textures: black, white, bright and in between.
std::string write_texture(const TemporaryDirectory& directory) {
    const std::string file = directory.file("texture.hdr");
    write_hdr(file, 4, 2, [](int x, int y) { return Rgb(x == 0 ? 0 : 0.5 * x, 0.25 * y, x == 3 ? 100 : 0.5); });
    return file;
}

Outcome run(Dice dice, const std::string& texture_file) {
    const Trial trial = random_trial(dice, texture_file);
    return run_trial(trial, dice);
}

int run_alone(Dice dice, const std::string& texture_file) {
    try {
        const Outcome outcome = run(dice, texture_file);
        std::cout << (outcome.rendered ? "rendered" : "refused: " + outcome.refusal) << '\n';
        return EXIT_SUCCESS;
    } catch (const std::exception& error) {
        std::cout << error.what() << '\n';
        return EXIT_FAILURE;
    }
}

std::vector<std::uint8_t> bytes_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

int run_seeds(const Seeds& seeds, const std::string& texture_file) {
    const Tally tally = supervise(seeds, [&](std::uint64_t seed) { return run(Dice(seed), texture_file); });
    const double scenes = static_cast<double>(tally.rendered + tally.refused + tally.findings);
    if (static_cast<double>(tally.rendered) < 0.8 * scenes) std::cout << "too few of the scenes are rendered\n";
    return tally.findings == 0 && static_cast<double>(tally.rendered) >= 0.8 * scenes ? EXIT_SUCCESS : EXIT_FAILURE;
}

int main_of(const std::vector<std::string>& arguments) {
    const TemporaryDirectory directory;
    const std::string texture_file = write_texture(directory);
    Seeds seeds{0, std::numeric_limits<std::uint64_t>::max() / 2, std::numeric_limits<double>::infinity()};
    for (const std::string& argument : arguments) {
        const std::size_t name_end = argument.find('=');
        const std::string name = argument.substr(0, name_end);
        const std::string value = name_end == std::string::npos ? "" : argument.substr(name_end + 1);
        if (name == "--seed") return run_alone(Dice(std::stoull(value)), texture_file);
        if (name == "--bytes") {
            const std::vector<std::uint8_t> bytes = bytes_of(value);
            return run_alone(Dice(bytes), texture_file);
        }
        if (name == "--count") {
            seeds.count = std::stoull(value);
        } else if (name == "--from") {
            seeds.first = std::stoull(value);
        } else if (name == "--seconds") {
            seeds.seconds = std::stod(value);
        } else {
            std::cout << kUsage;
            return EXIT_FAILURE;
        }
    }
    return run_seeds(seeds, texture_file);
}

}  // namespace
}  // namespace etendue::test

int main(int count, char** values) { return etendue::test::main_of({values + 1, values + count}); }
