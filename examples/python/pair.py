"""Two ellipsoids: the contact function, the distance, and where they are closest."""

import pypw85

r12 = [3, 2, 1]  # from the first centre to the second
# Quadratic forms, from semi-axes and quaternions (w, x, y, z)
q1 = pypw85.ellipsoid_quaternion([3, 2, 1], [1, 0, 0, 0])
q2 = pypw85.ellipsoid_quaternion([4, 1, 1], [0.9, 0.1, 0.3, 0.2])  # is normalised
mu2, lambda_ = pypw85.contact(r12, q1, q2)  # lambda_: see contact_geometry()
distance, p1, p2 = pypw85.distance(r12, q1, q2)
print(f"mu^2 = {mu2:.5f}: {'overlap' if mu2 < 1 else 'apart'}")
print(f"distance = {distance:.5f}, from ({p1[0]:.4f}, {p1[1]:.4f}, {p1[2]:.4f})")
