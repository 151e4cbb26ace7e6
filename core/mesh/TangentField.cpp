// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/TangentField.h"

#include "core/base/Hash.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include <glm/geometric.hpp>

namespace txn {
namespace {

using Complex = std::complex<double>;
using ComplexVector = Eigen::VectorXcd;
using ComplexMatrix = Eigen::SparseMatrix<Complex>;

constexpr int kMostIterations = 60;
constexpr double kConverged = 1e-5;   ///< change of the field per iteration, relative
constexpr double kSmallestCot = 0.02; ///< keeps slivers and obtuse triangles from pushing apart
constexpr double kLargestCot = 50.0;
constexpr double kShift = 1e-8; ///< makes the matrix definite where a parallel field exists

/// The plane orthogonal to a normal, as the complex plane.
struct Frame {
    glm::dvec3 normal;
    glm::dvec3 real;
    glm::dvec3 imaginary;

    explicit Frame(const glm::dvec3& n) : normal(n) {
        const glm::dvec3 axis =
            std::abs(n.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
        real = glm::normalize(axis - n * glm::dot(axis, n));
        imaginary = glm::cross(n, real);
    }
    Complex coordinates(const glm::dvec3& v) const {
        return {glm::dot(v, real), glm::dot(v, imaginary)};
    }
    glm::dvec3 vector(const Complex& z) const { return real * z.real() + imaginary * z.imag(); }
};

/// How the coordinates of a vector change from one frame to another when it is turned by the
/// smallest rotation between their normals: a factor of modulus 1.
Complex transport(const Frame& from, const Frame& to) {
    const glm::dvec3 axis = glm::cross(from.normal, to.normal);
    const double cosine = glm::dot(from.normal, to.normal);
    if (cosine < -1.0 + 1e-9)
        return 1.0; // no rotation is the smallest
    const glm::dvec3& v = from.real;
    const glm::dvec3 turned =
        v * cosine + glm::cross(axis, v) + axis * (glm::dot(axis, v) / (1.0 + cosine));
    const Complex z = to.coordinates(turned);
    return std::abs(z) > 0.0 ? z / std::abs(z) : Complex(1.0);
}

glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& otherwise) {
    const double length = glm::length(v);
    return length > 1e-6 && std::isfinite(length) ? v / length : otherwise;
}

/// The unknowns: one point per position.
struct Points {
    Weld weld;
    std::vector<Frame> frames;
    std::vector<std::uint32_t> part; ///< the connected part of each point
    std::size_t partCount = 0;
};

std::vector<Frame> framesOf(const TriangleMesh& mesh, const Weld& weld) {
    std::vector<glm::dvec3> sums(weld.pointCount, glm::dvec3(0.0));
    std::vector<glm::dvec3> some(weld.pointCount, glm::dvec3(0.0, 1.0, 0.0));
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const glm::dvec3 normal = unitOr(glm::dvec3(mesh.normals[v]), {0.0, 1.0, 0.0});
        sums[weld.pointOfVertex[v]] += normal;
        some[weld.pointOfVertex[v]] = normal;
    }
    std::vector<Frame> frames;
    frames.reserve(sums.size());
    for (std::size_t p = 0; p < sums.size(); ++p)
        frames.emplace_back(unitOr(sums[p], some[p]));
    return frames;
}

void findParts(const TriangleMesh& mesh, Points& points) {
    std::vector<std::uint32_t> parent(points.weld.pointCount);
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&](std::uint32_t p) {
        while (parent[p] != p)
            p = parent[p] = parent[parent[p]];
        return p;
    };
    for (const Triangle& triangle : mesh.triangles) {
        for (std::size_t k = 1; k < 3; ++k) {
            const auto a = root(points.weld.pointOfVertex[triangle[0]]);
            const auto b = root(points.weld.pointOfVertex[triangle[k]]);
            // The lower index stays the root, so that parts are numbered from their first point.
            parent[std::max(a, b)] = std::min(a, b);
        }
    }
    points.part.resize(parent.size());
    for (std::uint32_t p = 0; p < parent.size(); ++p)
        points.part[p] =
            parent[p] == p ? static_cast<std::uint32_t>(points.partCount++) : points.part[root(p)];
}

/// The energy's Hermitian matrix and the points' areas.
struct System {
    ComplexMatrix energy; ///< lower half
    Eigen::VectorXd mass; ///< mean 1
};

System assemble(const TriangleMesh& mesh, const Points& points) {
    const auto count = static_cast<Eigen::Index>(points.weld.pointCount);
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(count);
    System system;
    system.mass = Eigen::VectorXd::Zero(count);
    std::vector<Eigen::Triplet<Complex>> entries;
    entries.reserve(mesh.triangles.size() * 3 + points.weld.pointCount);
    for (const Triangle& triangle : mesh.triangles) {
        const double area = glm::length(areaVector(mesh, triangle));
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = points.weld.pointOfVertex[triangle[(k + 1) % 3]];
            const std::uint32_t b = points.weld.pointOfVertex[triangle[(k + 2) % 3]];
            system.mass[points.weld.pointOfVertex[triangle[k]]] += area;
            if (a == b)
                continue;
            const glm::dvec3 corner(mesh.positions[triangle[k]]);
            const glm::dvec3 toA = glm::dvec3(mesh.positions[triangle[(k + 1) % 3]]) - corner;
            const glm::dvec3 toB = glm::dvec3(mesh.positions[triangle[(k + 2) % 3]]) - corner;
            const double cotangent = area > 0.0 ? glm::dot(toA, toB) / area : 0.0;
            const double weight = 0.5 * std::clamp(cotangent, kSmallestCot, kLargestCot);
            diagonal[a] += weight;
            diagonal[b] += weight;
            const std::uint32_t low = std::min(a, b);
            const std::uint32_t high = std::max(a, b);
            entries.emplace_back(high,
                                 low,
                                 -weight * transport(points.frames[low], points.frames[high]));
        }
    }
    const double mean = system.mass.sum() / static_cast<double>(std::max<Eigen::Index>(count, 1));
    if (mean > 0.0)
        system.mass /= mean;
    for (Eigen::Index p = 0; p < count; ++p) {
        // Slivers must not have a say that their edges cannot answer; nor must loose vertices.
        system.mass[p] = std::max(system.mass[p], 1e-3);
        entries.emplace_back(p, p, diagonal[p] + kShift * system.mass[p]);
    }
    system.energy.resize(count, count);
    system.energy.setFromTriplets(entries.begin(), entries.end());
    return system;
}

/// Scales every part's field to a mean square of 1 per mass.
void normalizeParts(const Points& points, const Eigen::VectorXd& mass, ComplexVector& field) {
    std::vector<double> largest(points.partCount, 0.0);
    for (Eigen::Index p = 0; p < field.size(); ++p) {
        double& most = largest[points.part[static_cast<std::size_t>(p)]];
        most = std::max(most, std::abs(field[p]));
    }
    std::vector<double> sums(points.partCount, 0.0);
    std::vector<double> masses(points.partCount, 0.0);
    for (Eigen::Index p = 0; p < field.size(); ++p) {
        const std::uint32_t part = points.part[static_cast<std::size_t>(p)];
        if (largest[part] > 0.0)
            field[p] /= largest[part];
        sums[part] += mass[p] * std::norm(field[p]);
        masses[part] += mass[p];
    }
    for (Eigen::Index p = 0; p < field.size(); ++p) {
        const std::uint32_t part = points.part[static_cast<std::size_t>(p)];
        if (sums[part] > 0.0)
            field[p] *= std::sqrt(masses[part] / sums[part]);
    }
}

/// A field's phase is free on each part: turns each towards the target field.
void alignParts(const Points& points,
                const Eigen::VectorXd& mass,
                const ComplexVector& target,
                ComplexVector& field) {
    std::vector<Complex> products(points.partCount, 0.0);
    std::vector<double> masses(points.partCount, 0.0);
    for (Eigen::Index p = 0; p < field.size(); ++p) {
        const std::uint32_t part = points.part[static_cast<std::size_t>(p)];
        products[part] += mass[p] * std::conj(field[p]) * target[p];
        masses[part] += mass[p];
    }
    for (Eigen::Index p = 0; p < field.size(); ++p) {
        const std::uint32_t part = points.part[static_cast<std::size_t>(p)];
        // By symmetry there may be no better phase: then that of the start stays.
        if (std::abs(products[part]) > 1e-3 * masses[part])
            field[p] *= products[part] / std::abs(products[part]);
    }
}

/// The eigenvector of least energy of every part, by inverse iteration.
ComplexVector smoothestField(const System& system, const Points& points) {
    const auto count = static_cast<Eigen::Index>(points.frames.size());
    ComplexVector alongX(count);
    ComplexVector field(count);
    for (Eigen::Index p = 0; p < count; ++p) {
        const Frame& frame = points.frames[static_cast<std::size_t>(p)];
        alongX[p] = frame.coordinates({1.0, 0.0, 0.0});
        // An axis alone may be orthogonal to the solution, as on a torus; noise is so to nothing.
        const std::uint32_t bits = hash4(static_cast<std::uint32_t>(p), 1, 2, 3)[0];
        const double turn = 2.0 * std::numbers::pi * 0x1p-32 * bits;
        field[p] = alongX[p] + std::polar(0.5, turn);
    }
    normalizeParts(points, system.mass, field);
    Eigen::SimplicialLDLT<ComplexMatrix> solver(system.energy);
    if (solver.info() != Eigen::Success)
        return alongX;
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
        ComplexVector next = solver.solve(system.mass.cwiseProduct(field).eval());
        normalizeParts(points, system.mass, next);
        const double change = (next - field).norm();
        field = std::move(next);
        if (!(change > kConverged * field.norm()))
            break;
    }
    alignParts(points, system.mass, alongX, field);
    return field;
}

} // namespace

std::vector<glm::vec3> tangentField(const TriangleMesh& mesh) {
    assert(mesh.normals.size() == mesh.positions.size());
    if (mesh.positions.empty())
        return {};
    Points points;
    points.weld = weldByPosition(mesh.positions);
    points.frames = framesOf(mesh, points.weld);
    findParts(mesh, points);
    const ComplexVector field = smoothestField(assemble(mesh, points), points);

    std::vector<glm::vec3> tangents;
    tangents.reserve(mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const std::uint32_t point = points.weld.pointOfVertex[v];
        const Frame own(unitOr(glm::dvec3(mesh.normals[v]), {0.0, 1.0, 0.0}));
        const glm::dvec3 direction = points.frames[point].vector(field[point]);
        const glm::dvec3 inPlane = own.vector(own.coordinates(direction));
        tangents.emplace_back(unitOr(inPlane, own.real));
    }
    return tangents;
}

} // namespace txn
