// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/BuiltinMeshes.h"
#include "core/mesh/MeshIo.h"
#include "core/mesh/TangentField.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

using namespace txn;
using namespace txn::test;

namespace {

using Field = std::vector<glm::vec3>;

/// v turned by the smallest rotation that takes from to to.
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 axis = glm::cross(from, to);
    const double cosine = glm::dot(from, to);
    return v * cosine + glm::cross(axis, v) + axis * (glm::dot(axis, v) / (1.0 + cosine));
}

double signedAngle(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& normal) {
    return std::atan2(glm::dot(normal, glm::cross(from, to)), glm::dot(from, to));
}

/// The angle by which the field turns along each edge of a triangle, and how much a vector turns
/// that is carried around it.
struct Turns {
    std::array<double, 3> angles{};
    double holonomy = 0.0;
};

Turns turnsIn(const TriangleMesh& mesh, const Field& field, const Triangle& t) {
    Turns turns;
    const glm::dvec3 first(field[t[0]]);
    glm::dvec3 carried = first;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 from(mesh.normals[t[k]]);
        const glm::dvec3 to(mesh.normals[t[(k + 1) % 3]]);
        turns.angles[k] = signedAngle(turned(glm::dvec3(field[t[k]]), from, to),
                                      glm::dvec3(field[t[(k + 1) % 3]]),
                                      to);
        carried = turned(carried, from, to);
    }
    turns.holonomy = signedAngle(first, carried, glm::dvec3(mesh.normals[t[0]]));
    return turns;
}

double largestAngleIn(const TriangleMesh& mesh, const Field& field, const Triangle& t) {
    const auto angles = turnsIn(mesh, field, t).angles;
    return std::max({std::abs(angles[0]), std::abs(angles[1]), std::abs(angles[2])});
}

/// How the field winds around the triangles: index +1 or -1 at singular ones.
struct Winding {
    int sum = 0;
    int singular = 0;
    double largestAngle = 0.0;      ///< between neighbours anywhere
    std::vector<glm::dvec3> places; ///< of the singular triangles
};

Winding windingOf(const TriangleMesh& mesh, const Field& field) {
    Winding winding;
    for (const Triangle& t : mesh.triangles) {
        const Turns turns = turnsIn(mesh, field, t);
        const double total = turns.angles[0] + turns.angles[1] + turns.angles[2] + turns.holonomy;
        const auto index = static_cast<int>(std::lround(total / (2.0 * std::numbers::pi)));
        winding.sum += index;
        winding.singular += index != 0 ? 1 : 0;
        if (index != 0)
            winding.places.emplace_back(mesh.positions[t[0]]);
        winding.largestAngle = std::max(winding.largestAngle, largestAngleIn(mesh, field, t));
    }
    return winding;
}

/// Largest of |length - 1| and |tangent . normal|.
double worstTangent(const TriangleMesh& mesh, const Field& field) {
    if (field.size() != mesh.positions.size())
        return std::numeric_limits<double>::quiet_NaN();
    double worst = 0.0;
    for (std::size_t v = 0; v < field.size(); ++v) {
        const glm::dvec3 tangent(field[v]);
        const double error = std::max(std::abs(glm::length(tangent) - 1.0),
                                      std::abs(glm::dot(tangent, glm::dvec3(mesh.normals[v]))));
        if (!(error <= worst))
            worst = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
    }
    return worst;
}

double largestChange(const Field& a, const Field& b) {
    if (a.size() != b.size())
        return std::numeric_limits<double>::quiet_NaN();
    double largest = 0.0;
    for (std::size_t v = 0; v < a.size(); ++v)
        largest = std::max(largest, static_cast<double>(glm::distance(a[v], b[v])));
    return largest;
}

/// Largest difference between tangents at one position with one normal.
double largestSeam(const TriangleMesh& mesh, const Field& field) {
    const Weld weld = weldByPosition(mesh.positions);
    std::vector<std::size_t> first(weld.pointCount, mesh.positions.size());
    double largest = 0.0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        std::size_t& known = first[weld.pointOfVertex[v]];
        if (known == mesh.positions.size())
            known = v;
        if (mesh.normals[v] == mesh.normals[known])
            largest = std::max(largest, static_cast<double>(glm::distance(field[v], field[known])));
    }
    return largest;
}

TriangleMesh transformed(TriangleMesh mesh, float scale, const glm::vec3& shift) {
    for (glm::vec3& p : mesh.positions)
        p = p * scale + shift;
    return mesh;
}

/// Both meshes in one.
TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
    const auto offset = static_cast<std::uint32_t>(a.positions.size());
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    a.normals.insert(a.normals.end(), b.normals.begin(), b.normals.end());
    a.uvs.clear();
    for (const Triangle& t : b.triangles)
        a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    return a;
}

/// Every triangle with vertices of its own.
TriangleMesh cutUp(const TriangleMesh& mesh) {
    TriangleMesh cut;
    for (const Triangle& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(cut.positions.size());
        for (const std::uint32_t v : t) {
            cut.positions.push_back(mesh.positions[v]);
            cut.normals.push_back(mesh.normals[v]);
        }
        cut.triangles.push_back({first, first + 1, first + 2});
    }
    return cut;
}

/// In single precision.
constexpr double kUnitTolerance = 1e-6;

} // namespace

class TestTangentField : public QObject {
    Q_OBJECT

  private slots:
    void tangentsOfEveryMesh_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"plane", "sphere", "torus", "spot.obj", "suzi.obj", "teapot.obj"})
            QTest::newRow(name) << name;
    }

    void tangentsOfEveryMesh() {
        QFETCH(QString, name);
        auto mesh = builtinMesh(name.toStdString());
        if (!mesh) {
            const auto path =
                std::filesystem::path(TXN_SOURCE_DIR) / "../shared/meshes" / name.toStdString();
            if (!std::filesystem::exists(path))
                QSKIP("the public meshes are not here");
            auto loaded = loadMesh(path);
            TXN_OK(loaded);
            mesh = *std::move(loaded);
        }
        const Field field = tangentField(*mesh);
        TXN_AT_MOST(worstTangent(*mesh, field), kUnitTolerance);
        TXN_AT_MOST(largestSeam(*mesh, field), 0.0);
        QVERIFY(field == tangentField(*mesh));
        // A handful: legs, ears, handles and spouts want one or two each.
        TXN_AT_MOST(windingOf(*mesh, field).singular, 12);
    }

    void planesHaveParallelFields() {
        for (const int cells : {1, 2, 32}) {
            for (const glm::vec3& t : tangentField(planeMesh(cells)))
                TXN_AT_MOST(glm::distance(t, glm::vec3(1, 0, 0)), 1e-5);
        }
        // A plane that +x is orthogonal to.
        TriangleMesh wall = planeMesh(9);
        for (std::size_t v = 0; v < wall.positions.size(); ++v) {
            const glm::vec3 p = wall.positions[v];
            wall.positions[v] = {p.y, p.z, p.x};
            wall.normals[v] = {1, 0, 0};
        }
        const Field field = tangentField(wall);
        TXN_AT_MOST(worstTangent(wall, field), kUnitTolerance);
        for (const glm::vec3& t : field)
            TXN_AT_MOST(glm::distance(t, field[0]), 1e-5);
    }

    void torusHasNoSingularPoint() {
        TriangleMesh torus = torusMesh();
        // A vertex that no triangle uses changes nothing.
        torus.positions.emplace_back(9.0F, 9.0F, 9.0F);
        torus.normals.emplace_back(0.0F, 1.0F, 0.0F);
        const Winding winding = windingOf(torus, tangentField(torus));
        QCOMPARE(winding.singular, 0);
        TXN_AT_MOST(winding.largestAngle, 0.1);
    }

    /// Poincare and Hopf: the indices add up to the Euler characteristic.
    void sphereHasTwo() {
        const TriangleMesh sphere = sphereMesh();
        const Winding winding = windingOf(sphere, tangentField(sphere));
        QCOMPARE(winding.sum, 2);
        TXN_AT_MOST(winding.singular, 4);
    }

    /// At a distance d from a point of index 1, a field turns by 1 / d per length; the edges are at
    /// most 0.07 long. Holds away from the singular triangles, of which some must be left.
    void neighboursAreAlike() {
        const TriangleMesh sphere = sphereMesh();
        const Field field = tangentField(sphere);
        const Winding winding = windingOf(sphere, field);
        QVERIFY(!winding.places.empty());
        std::size_t compared = 0;
        for (const Triangle& t : sphere.triangles) {
            const glm::dvec3 place(sphere.positions[t[0]]);
            const bool near =
                std::any_of(winding.places.begin(), winding.places.end(), [&](const auto& other) {
                    return glm::distance(place, other) < 0.3;
                });
            if (near)
                continue;
            ++compared;
            TXN_AT_MOST(largestAngleIn(sphere, field, t), 0.3);
        }
        QVERIFY(compared > sphere.triangles.size() / 2);
    }

    void cutMeshesHaveTheSameField() {
        const TriangleMesh torus = torusMesh();
        const TriangleMesh cut = cutUp(torus);
        const Field whole = tangentField(torus);
        const Field parts = tangentField(cut);
        TXN_AT_MOST(worstTangent(cut, parts), kUnitTolerance);
        TXN_AT_MOST(largestSeam(cut, parts), 0.0);
        QCOMPARE(windingOf(cut, parts).singular, 0);
        // Points keep their order of first appearance only by chance; the field may differ by the
        // free phase alone, so compare what turns.
        TXN_AT_MOST(
            std::abs(windingOf(cut, parts).largestAngle - windingOf(torus, whole).largestAngle),
            0.02);
    }

    /// Also when their sizes differ by twelve orders of magnitude.
    void everyPartHasItsField() {
        const TriangleMesh mesh =
            joined(joined(torusMesh(), transformed(torusMesh(), 1e-6F, {3, 0, 0})),
                   transformed(planeMesh(8), 1e6F, {0, -2e6F, 0}));
        const Field field = tangentField(mesh);
        TXN_AT_MOST(worstTangent(mesh, field), kUnitTolerance);
        const std::size_t torus = torusMesh().positions.size();
        for (std::size_t v = 2 * torus; v < field.size(); ++v)
            TXN_AT_MOST(glm::distance(field[v], glm::vec3(1, 0, 0)), 1e-4);
        TriangleMesh first = torusMesh();
        QCOMPARE(windingOf(first, Field(field.begin(), field.begin() + static_cast<int>(torus)))
                     .singular,
                 0);
    }

    void sizeDoesNotMatter() {
        const TriangleMesh sphere = sphereMesh();
        const Field field = tangentField(sphere);
        // Powers of two scale exactly.
        for (const float scale : {0x1p-20F, 0x1p20F})
            TXN_AT_MOST(largestChange(field, tangentField(transformed(sphere, scale, {0, 0, 0}))),
                        1e-6);
        for (const float scale : {1e-6F, 1e6F}) {
            const TriangleMesh other = transformed(sphere, scale, {0, 0, 0});
            const Field scaled = tangentField(other);
            TXN_AT_MOST(worstTangent(other, scaled), kUnitTolerance);
            QCOMPARE(windingOf(other, scaled).sum, 2);
        }
    }

    void creasesProjectOneDirection() {
        // Two squares at a right angle, each with its own vertices and normals.
        TriangleMesh mesh;
        mesh.positions = {{0, 0, 0},
                          {0, 0, -1},
                          {-1, 0, -1},
                          {-1, 0, 0},
                          {0, 0, 0},
                          {0, 0, -1},
                          {0, -1, -1},
                          {0, -1, 0}};
        mesh.normals = {{0, 1, 0},
                        {0, 1, 0},
                        {0, 1, 0},
                        {0, 1, 0},
                        {1, 0, 0},
                        {1, 0, 0},
                        {1, 0, 0},
                        {1, 0, 0}};
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}};
        const Field field = tangentField(mesh);
        TXN_AT_MOST(worstTangent(mesh, field), kUnitTolerance);
        // Going over the edge, +x on top becomes -y at the side.
        TXN_AT_MOST(glm::distance(field[2], glm::vec3(1, 0, 0)), 0.05);
        TXN_AT_MOST(glm::distance(field[6], glm::vec3(0, -1, 0)), 0.05);
    }

    void oddMeshes() {
        TriangleMesh odd;
        odd.positions =
            {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {9, 9, 9}, {9, 9, 9}};
        odd.normals.assign(7, glm::vec3(0, 0, 1));
        odd.normals[4] = {0, 0, -1}; // opposite to its neighbours'
        odd.normals[5] = {1, 0, 0};  // cancel each other
        odd.normals[6] = {-1, 0, 0};
        // Three triangles at one edge, a degenerate one, one twice, one from the other side.
        odd.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 0, 1}, {0, 1, 2}, {2, 1, 0}};
        TXN_AT_MOST(worstTangent(odd, tangentField(odd)), kUnitTolerance);
        odd.triangles.clear();
        TXN_AT_MOST(worstTangent(odd, tangentField(odd)), kUnitTolerance);
        QVERIFY(tangentField({}).empty());
    }

    /// A mesh of random slivers with random normals: nothing to be smooth, all to be finite.
    void noiseIsNoProblem() {
        TestRandom random(5);
        TriangleMesh mesh;
        for (int v = 0; v < 300; ++v) {
            mesh.positions.emplace_back(random.uniform(),
                                        1e-4 * random.uniform(),
                                        random.uniform());
            mesh.normals.push_back(glm::vec3(glm::normalize(
                glm::dvec3(random.gaussian(), random.gaussian(), random.gaussian()))));
        }
        for (int t = 0; t < 900; ++t)
            mesh.triangles.push_back({static_cast<std::uint32_t>(random.below(300)),
                                      static_cast<std::uint32_t>(random.below(300)),
                                      static_cast<std::uint32_t>(random.below(300))});
        TXN_AT_MOST(worstTangent(mesh, tangentField(mesh)), kUnitTolerance);
    }
};

QTEST_APPLESS_MAIN(TestTangentField)
#include "TestTangentField.moc"
