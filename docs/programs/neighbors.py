import numpy as np
import pypw85

rng = np.random.default_rng(1)
n = 1000
q = pypw85.ellipsoid_quaternion([0.5, 0.5, 1.5], rng.normal(size=(n, 4)))
cell = np.array([[15.0, 0, 0], [5, 14, 0], [-3, 2, 15]])
centers = rng.uniform(size=(n, 3)) @ cell

neighbors = pypw85.neighbors(centers, q, cell, skin=0.2)
pairs, images = neighbors.pairs, neighbors.images
overlap = pypw85.overlap_pairs(pairs, centers, q, cell, images=images)
print(len(neighbors), "pairs,", np.count_nonzero(overlap), "overlap")

centers += rng.uniform(-0.05, 0.05, size=(n, 3))
print("holds after a step:", neighbors.holds(centers, q, cell))
