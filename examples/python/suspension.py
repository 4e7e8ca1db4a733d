"""Whether a suspension of ellipsoids is inside of its container, an ellipsoid; and how large the container must be."""

import numpy as np
import pypw85

# A drop, and particles with their centres in a smaller copy of the drop.
container = pypw85.ellipsoid([30, 20, 20], np.eye(3))
random = np.random.default_rng(1)
count = 10_000
directions = random.normal(size=(count, 3))
directions /= np.linalg.norm(directions, axis=1, keepdims=True)
radii = 0.955 * np.cbrt(random.random((count, 1)))
centers = radii * directions * np.array([30, 20, 20])
q = pypw85.ellipsoid_quaternion([1, 0.5, 0.4], random.normal(size=(count, 4)))

inside = pypw85.contains(centers, container, q)
print(f"{inside.sum()} of {count} particles are inside")

# The particle that sticks out most, and the container that has all of them inside.
mu2, points = pypw85.containment(centers, container, q)
worst = mu2.argmax()
factor = np.sqrt(mu2[worst])
print("one sticks out at", points[worst].round(3), f"by a factor of {factor:.6f}")
larger = mu2[worst] * (1 + 1e-12) * container
all_inside = pypw85.contains(centers, larger, q).all()
print("all are inside of the larger container:", all_inside)
