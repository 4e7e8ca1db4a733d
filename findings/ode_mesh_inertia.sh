#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The moments of inertia of a triangle mesh whose centre of mass is not at the origin contain the offset twice, and the usual shift to the
# centre of mass removes it once: an ellipsoid that is drawn off its centre turns as if it were several times as heavy.
#
# Open Dynamics Engine 0.16.2 (Debian 12, libode8 2:0.16.2-1), dMassSetTrimesh with density 1 on a mesh of the ellipsoid (1, 2, 3) whose
# vertices have the offset c. The manual says that I is the "3x3 inertia tensor in body frame, about POR", the point of reference, here the
# origin; its example of moving meshes (demo_moving_trimesh) calls dMassTranslate(&m, -m.c[0], -m.c[1], -m.c[2]) next, and so do programs.
# Moments about x, y, z divided by the mass, seen on 30 November 2026; the mesh, which is inside the ellipsoid, has 2.596 1.998 0.996:
#
#   c              dMassSetTrimesh                     after dMassTranslate(-c)     true
#   (0, 0, 0)      2.596 1.998 0.996                   2.596 1.998 0.996            2.6 2 1
#   (0.5, 1, 1.5)  9.096 6.998 3.496                   5.846 4.498 2.246            2.6 2 1
#   (10, 0, 0)     2.596 201.998 200.996               2.596 101.998 100.996        2.6 2 1
#
# That is, the first column has I + 2 m (c'c - c c'). Mass and m.c are right, and dMassCheck accepts all. Capsules, boxes and cylinders have
# right moments. Move the vertices, so that the centre of mass is 0, before the call.
# Needs g++ and apt-get.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -qq libode8=2:0.16.2-1 libode-dev=2:0.16.2-1 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
cat >check.cpp <<'END'
#include <cmath>
#include <cstdio>
#include <ode/ode.h>
#include <vector>

struct Mesh {
  std::vector<double> vertices;
  std::vector<dTriIndex> triangles;
};

// Triangles are anticlockwise, seen from outside.
static Mesh ellipsoid(double a, double b, double c, double const offset[3]) {
  Mesh mesh;
  unsigned const n = 48;
  for (unsigned i = 0; i <= n; i++)
    for (unsigned j = 0; j < n; j++) {
      double const t = M_PI * i / n, p = 2 * M_PI * j / n;
      double const x[3] = {a * std::sin(t) * std::cos(p), b * std::sin(t) * std::sin(p), c * std::cos(t)};
      for (int k = 0; k < 3; k++) mesh.vertices.push_back(x[k] + offset[k]);
    }
  for (unsigned i = 0; i < n; i++)
    for (unsigned j = 0; j < n; j++) {
      unsigned const up = i * n, down = up + n, next = (j + 1) % n;
      if (i > 0) mesh.triangles.insert(mesh.triangles.end(), {up + j, down + j, up + next});
      if (i < n - 1) mesh.triangles.insert(mesh.triangles.end(), {up + next, down + j, down + next});
    }
  return mesh;
}

// Sums over the tetrahedra between the triangles and the origin: 6 V, and the 9 integrals of x x', times 120. Independent of ODE.
static void integrate(Mesh const &mesh, double &six_volumes, double second[3][3]) {
  six_volumes = 0;
  for (int k = 0; k < 9; k++) second[k / 3][k % 3] = 0;
  for (size_t i = 0; i < mesh.triangles.size(); i += 3) {
    double const *v[3];
    for (size_t k = 0; k < 3; k++) v[k] = &mesh.vertices[3 * mesh.triangles[i + k]];
    double const determinant = v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) - v[0][1] * (v[1][0] * v[2][2] - v[1][2] * v[2][0]) +
                               v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
    six_volumes += determinant;
    for (int k = 0; k < 3; k++)
      for (int l = 0; l < 3; l++) {
        double const sum_k = v[0][k] + v[1][k] + v[2][k], sum_l = v[0][l] + v[1][l] + v[2][l];
        second[k][l] += determinant * (v[0][k] * v[0][l] + v[1][k] * v[1][l] + v[2][k] * v[2][l] + sum_k * sum_l);
      }
  }
}

// Whether I / mass is that of the ellipsoid (1, 2, 3) about its centre, plus "times" that of its mass at the offset.
static bool has(dMass const &m, double const c[3], int times) {
  double const squares[3] = {1, 4, 9};
  bool same = true;
  for (int k = 0; k < 3; k++) printf(" %.3f", m.I[4 * k + k] / m.mass);
  for (int k = 0; k < 3; k++)
    for (int l = 0; l < 3; l++) {
      double const of_centre = k == l ? (14 - squares[k]) / 5 : 0;
      double const of_offset = (k == l ? c[0] * c[0] + c[1] * c[1] + c[2] * c[2] : 0) - c[k] * c[l];
      same &= std::fabs(m.I[4 * k + l] / m.mass - of_centre - times * of_offset) < 5e-3;
    }
  return same;
}

static int check(double const c[3]) {
  Mesh const mesh = ellipsoid(1, 2, 3, c);
  dTriMeshDataID const data = dGeomTriMeshDataCreate();
  dGeomTriMeshDataBuildDouble(data, mesh.vertices.data(), 3 * sizeof(double), static_cast<int>(mesh.vertices.size() / 3),
                              mesh.triangles.data(), static_cast<int>(mesh.triangles.size()), 3 * sizeof(dTriIndex));
  dGeomID const geometry = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
  dMass m;
  dMassSetTrimesh(&m, 1, geometry);
  double six_volumes, second[3][3];
  integrate(mesh, six_volumes, second);
  double const true_moment = (second[1][1] + second[2][2]) / 20 / six_volumes; // about x, through the origin, divided by the mass
  printf("offset %g %g %g:", c[0], c[1], c[2]);
  bool right = std::fabs(m.mass - six_volumes / 6) < 1e-3 && has(m, c, 2);
  for (int k = 0; k < 3; k++) right &= std::fabs(m.c[k] - c[k]) < 1e-6;
  right &= std::fabs(m.I[0] / m.mass - true_moment - c[1] * c[1] - c[2] * c[2]) < 1e-6;
  printf("; about the origin, from its tetrahedra, the first is %.3f; after the shift", true_moment);
  dMassTranslate(&m, -m.c[0], -m.c[1], -m.c[2]);
  right &= has(m, c, 1) && dMassCheck(&m);
  printf("\n");
  dGeomDestroy(geometry);
  dGeomTriMeshDataDestroy(data);
  return !right;
}

int main() {
  dInitODE();
  double const offsets[3][3] = {{0, 0, 0}, {0.5, 1, 1.5}, {10, 0, 0}};
  return check(offsets[0]) | check(offsets[1]) | check(offsets[2]);
}
END
libraries=$dir/usr/lib/x86_64-linux-gnu
g++ -std=c++17 -O1 -w -DdIDEDOUBLE -Iusr/include check.cpp -o check "$libraries/libode.so.8"
LD_LIBRARY_PATH=$libraries ./check
