// Lancret's hair compared with Mitsuba 3's, and both with the same equations in double
// precision.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "render_test/material/hair_bsdf.h"

namespace lancret {
namespace {

namespace fs = std::filesystem;

/// A line of mitsuba_hair.py.
struct Row {
    std::vector<double> setting;  ///< beta_m, beta_n, tilt, sigma_a, eta
    double h;
    double mitsuba;  ///< its value
    double exact;    ///< the model in double
    double bessel;   ///< the model in double with Mitsuba's own Bessel function
    double ours;
};

using Table = std::map<std::vector<double>, std::vector<Row>>;

Table read_table(const fs::path& path) {
    std::ifstream file(path);
    Table table;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::vector<double> n;
        std::stringstream fields(line);
        for (std::string field; std::getline(fields, field, ',');) {
            n.push_back(std::stod(field));
        }
        if (n.size() != 13) throw std::runtime_error("not a line of mitsuba_hair.py");
        HairMaterial m;
        m.beta_m = float(n[0]), m.beta_n = float(n[1]), m.tilt = float(n[2]);
        m.sigma_a = Vec3f::Constant(float(n[3]));
        m.eta = float(n[4]);
        const auto sine = float(n[5]);
        const HairModel model(m);
        const HairBsdf bsdf(model, Vec3f(sine, 0, std::sqrt(1 - sine * sine)),
                            float(n[6]));
        const Vec3f wi{float(n[7]), float(n[8]), float(n[9])};
        const std::vector<double> setting(n.begin(), n.begin() + 5);
        table[setting].push_back(
            {setting, n[6], n[10], n[11], n[12], double(bsdf.evaluate(wi).value.x())});
    }
    return table;
}

double scale_of_logistic(const Row& row) {
    const double b = row.setting[1];
    return 0.626657 * (0.265 * b + 1.194 * b * b + 5.372 * std::pow(b, 22));
}

/// The width of TT, the narrowest lobe, radian.
double narrowest(const Row& row) {
    const double b = row.setting[0];
    return (0.726 * b + 0.812 * b * b + 3.7 * std::pow(b, 20)) / 2;
}

/// Relative error of a value in single precision. The logarithm of a lobe has the slope 1
/// / s by azimuth; azimuths are sums of five angles of up to 3 pi, each rounded to at
/// most 5e-7. By inclination its slope is d / v at d from the peak, and d is at most 4.3
/// sqrt(v) where values are above 1e-4 of the peak. Sines of inclinations are accurate to
/// 6e-8 and their cosines, down to 0.17, to 6e-8 / 0.17, turned by the tilt and
/// subtracted: 1e-6 in all. The rest is a dozen products: 1e-6.
double rounding(const Row& row) {
    return 2.5e-6 / scale_of_logistic(row) + 4.3e-6 / narrowest(row) + 1e-6;
}

/// Additional error of Mitsuba. It computes the angle of h by an arc cosine near one,
/// accurate to 1.2e-7 / angle or to the root of that, and each azimuth contains it two to
/// six times. It also adds exponents of the size 1 / v before they cancel.
double mitsuba_rounding(const Row& row) {
    const double angle = std::min(1.2e-7 / std::max(std::abs(row.h), 1e-9), 3.5e-4);
    return rounding(row) + 6 * angle / scale_of_logistic(row) +
           4 * 1.2e-7 / (narrowest(row) * narrowest(row));
}

struct Differences {
    int values = 0;
    double most = 0, squares = 0;
    void add(double difference) {
        ++values;
        most = std::max(most, std::abs(difference));
        squares += difference * difference;
    }
    double rms() const { return std::sqrt(squares / values); }
};

/// Checks a table and prints the figures of docs/hair_bsdf.md.
void compare(const Table& table, std::size_t settings) {
    ASSERT_EQ(table.size(), settings);
    std::printf(
        "beta_m beta_n   tilt sigma_a  eta values | double: most rms | Mitsuba: most rms "
        "| Mitsuba's Bessel: most rms\n");
    for (const auto& [setting, rows] : table) {
        double peak = 0;
        for (const Row& row : rows) peak = std::max(peak, row.exact);
        Differences exact, mitsuba, bessel;
        for (const Row& row : rows) {
            // Relative differences are meaningless where a lobe has decayed.
            if (row.exact < 1e-4 * peak) continue;
            const double same = row.ours * row.bessel / row.exact;
            EXPECT_NEAR(row.ours / row.exact, 1, rounding(row)) << row.h;
            EXPECT_NEAR(row.mitsuba / same, 1, rounding(row) + mitsuba_rounding(row))
                << row.h;
            exact.add(row.ours / row.exact - 1);
            mitsuba.add(row.mitsuba / row.ours - 1);
            bessel.add(row.mitsuba / same - 1);
        }
        EXPECT_GE(exact.values, 2) << setting[0] << ' ' << setting[1];
        std::printf(
            "%6.2f %6.2f %6.3f %7.2f %4.2f %6d | %.1e %.1e | %.1e %.1e | %.1e %.1e\n",
            setting[0], setting[1], setting[2], setting[3], setting[4], exact.values,
            exact.most, exact.rms(), mitsuba.most, mitsuba.rms(), bessel.most,
            bessel.rms());
    }
}

const fs::path kHere = fs::path(LANCRET_SOURCE_DIR) / "tests" / "render_test";

TEST(HairMitsuba, DiffersOnlyByMitsubasBesselFunction) {
    compare(read_table(kHere / "mitsuba_3.9.1_hair.csv"), 13);
}

TEST(SlowHairMitsuba, DiffersOnlyByMitsubasBesselFunction) {
    const char* python = std::getenv("LANCRET_MITSUBA_PYTHON");
    if (!python || !*python) {
        GTEST_SKIP() << "LANCRET_MITSUBA_PYTHON names no Python that has Mitsuba: `make "
                        "test-slow` makes one where python3-venv and PyPI are there";
    }
    const fs::path out = fs::temp_directory_path() /
                         ("lancret_mitsuba_" + std::to_string(std::rand()) + ".csv");
    const std::string command = std::string("'") + python + "' '" +
                                (kHere / "mitsuba_hair.py").string() +
                                "' --each 4000 > '" + out.string() + "'";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    compare(read_table(out), 13);
    fs::remove(out);
}

}  // namespace
}  // namespace lancret
