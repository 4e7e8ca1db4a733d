"""What pypw85.plot draws, as on the page on drawing."""

import pypw85
from style import plt, save

plt.rcParams.update(plt.rcParamsDefault)
q1 = pypw85.ellipsoid_quaternion([3, 2, 1], [1, 0, 0, 0])
q2 = pypw85.ellipsoid_quaternion([4, 1, 1], [0.9, 0.1, 0.3, 0.2])
save(pypw85.plot([0, 0, 0], q1, [3, 4, 3], q2).figure, "plot.png")
