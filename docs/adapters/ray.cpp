// Kernels of one's own as a program that `cargo xtask conform` can judge.
//
//     c++ -std=c++20 -O2 -ffp-contract=off docs/adapters/ray.cpp -o ray
//     cargo xtask conform -- ./ray
//
// It reads the few keys it needs without a JSON library: floats are quoted bits, keys are unique
// within a request of this kind, and other kinds are answered as unsupported.

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>

using Vector = std::array<float, 3>;

float dot(Vector a, Vector b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector along(Vector a, float t, Vector b) {
    return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}

// The kernel under test: replace it by yours. (Ray Tracing Gems, chapter 7, for any direction.)
std::optional<float> intersect_sphere(Vector o, Vector d, Vector c, float r, float tmin, float tmax) {
    Vector f = along(o, -1, c);
    float a = dot(d, d), b = -dot(f, d);
    Vector aside = along(f, b / a, d);
    float root = std::sqrt(a * (r * r - dot(aside, aside)));
    float q = b >= 0 ? b + root : b - root;
    float first = (dot(f, f) - r * r) / q, second = q / a;
    float near = b >= 0 ? first : second, far = b >= 0 ? second : first;
    for (float t : {near, far})
        if (r > 0 && t >= tmin && t <= tmax && std::isfinite(t)) return t;
    return {};
}

// The n-th quoted text after "key".
std::string text(const std::string& line, const std::string& key, int n = 0) {
    size_t begin = line.find('"', line.find("\"" + key + "\":") + key.size() + 3);
    for (; n > 0; n--) begin = line.find('"', line.find('"', begin + 1) + 1);
    return line.substr(begin + 1, line.find('"', begin + 1) - begin - 1);
}

float number(const std::string& line, const std::string& key, int n = 0) {
    return std::bit_cast<float>(uint32_t(std::stoul(text(line, key, n), nullptr, 16)));
}

Vector vector(const std::string& line, const std::string& key) {
    return {number(line, key, 0), number(line, key, 1), number(line, key, 2)};
}

int main() {
    for (std::string line; std::getline(std::cin, line);) {
        std::string out = "\"unsupported\":\"a sphere in f32 is all there is\"";
        if (text(line, "kind") == "ray_sphere" && text(line, "prec") == "f32") {
            auto t = intersect_sphere(vector(line, "o"), vector(line, "d"), vector(line, "c"),
                                      number(line, "r"), number(line, "tmin"), number(line, "tmax"));
            char bits[11] = "null";
            if (t) std::snprintf(bits, sizeof bits, "\"%08x\"", std::bit_cast<uint32_t>(*t));
            out = "\"out\":{\"t\":" + std::string(bits) + "}";
        }
        std::cout << "{\"id\":\"" << text(line, "id") << "\"," << out << "}\n";
    }
}
