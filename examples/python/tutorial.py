"""Two ellipsoids, whether they overlap, and where they would touch."""

import numpy as np

import pypw85

np.set_printoptions(precision=6, suppress=False)

# An oblate spheroid and a prolate one: centre, direction of the axis, equatorial and
# polar radius.
x1 = np.array([-0.5, 0.4, -0.7])
n1 = np.array([0.0, 0.0, 1.0])
a1, c1 = 10, 0.1
x2 = np.array([0.2, -0.3, 0.4])
n2 = np.array([1.0, 0.0, 0.0])
a2, c2 = 0.5, 5.0

# The library knows an ellipsoid by its quadratic form.
r12 = x2 - x1
q1 = pypw85.spheroid(a1, c1, n1)
q2 = pypw85.spheroid(a2, c2, n2)

mu2, lambda_ = pypw85.contact_function(r12, q1, q2)
print(f"μ² = {mu2:.10f}")
print(f"λ = {lambda_:.10f}")
print("overlap:", bool(pypw85.overlap(r12, q1, q2)))

# Scaled by μ, their centres fixed, the ellipsoids touch in one point with a common
# normal.
point, normal = pypw85.contact_geometry(r12, q1, q2, lambda_)
print("contact point:", x1 + point)
print("normal:", normal)

# The same by hand: that point is on both scaled ellipsoids, whose normals there are
# opposite.
Q1, Q2 = mu2 * pypw85.full(q1), mu2 * pypw85.full(q2)
outward1 = np.linalg.solve(Q1, point)
outward2 = np.linalg.solve(Q2, point - r12)
print(f"on ellipsoid 1: {outward1 @ point:.9f}")
print(f"on ellipsoid 2: {outward2 @ (point - r12):.9f}")
cosine = outward1 @ outward2 / np.linalg.norm(outward1) / np.linalg.norm(outward2)
print(f"cosine of the angle between the outward normals: {cosine:.9f}")

# Many pairs at once: leading dimensions broadcast.
distances = np.array([0.25, 0.5, 1.0, 2.0])
mu2, lambda_ = pypw85.contact(distances[:, np.newaxis] * r12, q1, q2)
print("μ at 1/4, 1/2, 1 and 2 times the distance:", np.sqrt(mu2))

# A bad row does not spoil the others.
q = np.stack([q1, q2, np.zeros(6)])
with np.errstate(invalid="ignore"):
    mu2, lambda_ = pypw85.contact(r12, q, q2)
print("bad rows:", pypw85.bad_rows(mu2))
try:
    pypw85.contact(r12, q[2], q2)
except pypw85.PW85Error as error:
    print("because of", error)

# Neighbours in a periodic cell.
centers = np.array([[0.5, 0, 0], [9.5, 0, 0], [5.0, 0, 0]])
spheres = np.tile(pypw85.spheroid(1, 1, [0, 0, 1]), (3, 1))
cell = 10 * np.eye(3)
print("overlaps:", pypw85.overlap_pairs([[0, 1], [0, 2]], centers, spheres, cell=cell))
