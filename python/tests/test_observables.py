# SPDX-License-Identifier: BSD-3-Clause
"""Averages of simulations: errors by blocking, the equation of state by two routes, pair correlations, directors."""

import itertools
import os

import numpy as np
import pytest

import pypw85
from pypw85 import _blocking, _observables, _statistics
from systems import CELL


def averages_of(samples):
    averages = pypw85.Blocking(np.shape(samples)[1] if np.ndim(samples) > 1 else 1)  # numbers of a sample
    for sample in samples:
        averages.add(sample)
    return averages


@pytest.mark.parametrize("unit", [1.0, 2.0**40, 2.0**-40])
def test_blocks(rng, unit):
    """Each length of blocks, against averages of slices."""
    samples = unit * (3 + rng.normal(size=(43, 2)))
    averages = averages_of(samples)
    assert len(averages) == 43
    np.testing.assert_allclose(averages.estimate().value, samples.mean(axis=0), rtol=1e-14)
    for level in range(4):
        count = 43 >> level
        blocks = samples[: count << level].reshape(count, -1, 2).mean(axis=1)
        expected = blocks.var(axis=0, ddof=1) / count
        np.testing.assert_allclose(averages.squared_error(level), expected, rtol=1e-12)


def correlated(rng, time, shape):
    """Gaussian numbers whose correlation falls by a factor e in this time: n (1 - a)/(1 + a) independent ones, a = exp(-1/time)."""
    a = np.exp(-1 / time)
    samples = rng.normal(size=shape)
    samples[1:] *= np.sqrt(1 - a * a)
    for before, after in itertools.pairwise(samples):
        after += a * before
    return samples, shape[0] * (1 - a) / (1 + a)


def rms(numbers):
    return np.sqrt(np.mean(np.square(numbers)))


# Numbers of samples, times of correlation, and the part of the variance that is correlated; the rest is white noise
MIXTURES = [(256, 0.1, 1.0), (1000, 0.1, 1.0), (200, 5.0, 1.0), (1000, 5.0, 1.0), (4096, 16.0, 1.0), (8000, 200.0, 0.02), (2000, 50.0, 0.1)]


@pytest.mark.parametrize("unit", [1.0, 2.0**-40])
@pytest.mark.parametrize("number, time, part", MIXTURES)
def test_errors_of_correlated_samples(rng, number, time, part, unit):
    """Deviations over their errors have the mean square of a standard error: between 0.9² and 1.15². With 400 runs, their root mean
    square itself has the error 0.04. The runs stand beside each other here, and each decides for itself whether it is too short."""
    samples = np.sqrt(part) * correlated(rng, time, (number, 400))[0] + np.sqrt(1 - part) * rng.normal(size=(number, 400))
    averages = averages_of(unit * (3 + samples))
    error, independent = averages.errors(averages.squared_error)
    known = ~averages.too_slow()
    assert known.mean() > 0.97
    assert 0.9 < rms(((averages.estimate().value - 3 * unit) / error)[known]) < 1.15
    # The variance of the mean is that of the noise and of the correlated part, whose number of independent samples is known. The largest
    # of five estimates is up to a third too large for independent samples.
    a = np.exp(-1 / time)
    expected = number / (1 - part + part * (1 + a) / (1 - a))
    assert np.median(independent) == pytest.approx(expected, rel=0.35)


def shortest_blocks(samples):
    """Averages of 16 samples. Of 992, errors are those of 62, 31, and 15 blocks: the averages have the errors of the samples."""
    return samples.reshape(62, 16, -1).mean(axis=1)


def test_the_slowest_decides(rng):
    """A slow part of 2 % of the variance of a number cannot be seen in 5 of its times. Another number of the run that shows it tells."""
    slow = correlated(rng, 200.0, (992, 30))[0]
    mixed = np.sqrt(0.02) * slow + np.sqrt(0.98) * rng.normal(size=(992, 30))
    mixed, slow = shortest_blocks(mixed), shortest_blocks(slow)
    both = np.stack([mixed, slow], -1).swapaxes(0, 1)
    alone, together = ([averages_of(run).estimate().error for run in runs] for runs in (mixed.T, both))
    assert np.isfinite(alone).mean() > 0.9
    assert np.isnan(together).mean() > 0.5 and all(np.isnan(run).all() or np.isfinite(run).all() for run in together)


def test_errors_beside_the_slowest(rng):
    """White noise that has a part of a slow number of the same run, which shows how slow it is: in 20 of its times the error is right, too.
    So are those of the slow number and of noise beside them."""
    found, part = [], 0.02
    for _ in range(150):
        slow, noise = correlated(rng, 50.0, (992, 1))[0][:, 0], rng.normal(size=(2, 992))
        run = np.stack([slow, np.sqrt(part) * slow + np.sqrt(1 - part) * noise[0], noise[1]], axis=1)
        found.append(averages_of(2.0**30 * shortest_blocks(run)).estimate()[:2])
    values, errors = np.moveaxis(found, 1, 0)
    known = np.isfinite(errors[:, 0])
    assert known.mean() > 0.8
    for column in range(3):
        assert 0.8 < rms((values / errors)[known, column]) < 1.15, column


# Times of correlation over the length of a run
LADDER = (1 / 400, 1 / 200, 1 / 100, 1 / 50, 1 / 25, 1 / 12, 1 / 6, 1 / 3, 1)
RESOLVED_RMS = 1.3


def judged(averages, *others):
    """z of the runs of which errors are printed: none of their numbers has too few independent samples. The runs stand beside each other
    here, as numbers of one sample, and each is judged for itself."""
    numbers = [averages, *others]
    known = np.all([one.resolved() for one in numbers], axis=0)
    samples = np.min([one.errors(one.squared_error)[1] for one in numbers], axis=0)
    error = averages.errors(averages.squared_error)[0] * _blocking.widening(samples, averages.drifts())
    return (averages.estimate().value / error)[known]


# Their errors are those of 62 and of 32 shortest blocks, and 62 and 64 say whether these are known.
LENGTHS = (1000, 1030)


@pytest.mark.parametrize("number", LENGTHS)
@pytest.mark.parametrize("kind", ["exponential", "exponential and white", "relaxing"])
def test_printed_errors(rng, kind, number):
    """Numbers with the mean 0, whose slow part has times up to the length of the run; another number of the run shows the
    slow part, as the order of a nematic does. Where an error is printed, the root mean square of z is at most 1.3; errors of runs that are
    long are printed, and those of short ones are not."""
    runs, found, shares = 400, [], []
    for time in LADDER:
        slow, noise = correlated(rng, time * number, (number, runs))[0], rng.normal(size=(number, runs))
        if kind == "exponential":
            z = judged(averages_of(slow))
        elif kind == "exponential and white":
            z = judged(averages_of(np.sqrt(0.5) * (slow + noise)), averages_of(slow))
        else:  # from a start that is far away
            z = judged(averages_of(noise + 20 * np.exp(-np.arange(number) / (time * number))[:, None]))
        found.append(z)
        shares.append(len(z) / runs)
    assert rms(np.concatenate(found)) < RESOLVED_RMS, (shares, [rms(z) for z in found])
    assert max(shares[-3:]) < 0.02, shares
    assert kind == "relaxing" or min(shares[:2]) > 0.85, shares


def test_resolved_at_any_length(rng):
    """White noise has an error in nine of ten runs, or more, whatever the number of samples is between two powers of two."""
    for number in (100, 191, 192, 255, 1030, 1100, 1300, 1535, 1536, 2000):
        share = averages_of(rng.normal(size=(number, 1000))).resolved().mean()
        assert share > 0.9, (number, share)


# Ten times as many runs, and the table is printed (pytest -s)
IS_THOROUGH = "PW85_ALL_INPUTS" in os.environ
# A row of the table has so few runs with errors that they say nothing of a root mean square, below this part.
LEAST_SHARE = 0.02
# The drift of a straight line from the start to the end, over the error of the mean
LINES = (0, 2, 4, 6, 8, 10, 14, 20)


# A slow part that no other number of the run shows can be told from noise up to this time, and a relaxation up to the next one.
LONGEST_HIDDEN, LONGEST_RELAXATION = 1 / 25, 1 / 3


def rows_of_table(rng, number, runs):
    """Families of series of numbers with the mean 0, or that end there: the name, the time of correlation over the length of the run or the
    drift, whether the samples can tell how slow they are, and z of those that have an error."""
    noise = rng.normal(size=(number, runs))
    for time in LADDER:
        slow = correlated(rng, time * number, (number, runs))[0]
        shown = averages_of(slow)
        yield "exponential", time, True, judged(shown)
        for part in (0.5, 0.1):
            mixed = averages_of(np.sqrt(part) * slow + np.sqrt(1 - part) * noise)
            yield f"{part:.0%} exponential, shown", time, True, judged(mixed, shown)
            yield f"{part:.0%} exponential, hidden", time, time <= LONGEST_HIDDEN, judged(mixed)
        for start in (20, 1, 0.3):
            relaxing = noise + start * np.exp(-np.arange(number) / (time * number))[:, None]
            yield f"noise, relaxing from {start}", time, time <= LONGEST_RELAXATION, judged(averages_of(relaxing))
    for time in (0.1, 10.0):
        samples, independent = correlated(rng, time, (number, runs))
        for drift in LINES:
            line = np.linspace(drift / np.sqrt(independent), 0, number)[:, None]
            yield f"line, time {time}", drift, True, judged(averages_of(samples + line))


@pytest.mark.parametrize("number", LENGTHS)
def test_table_of_printed_errors(rng, number):
    """In each family of series the rms of z is at most 1.3 among the runs that have an error, if these are 2 % or more, and if the
    samples can tell how slow they are. The mean that is meant is that of the state at the end of a drift. With m errors, an rms itself errs
    by 1/√(2 m), of which two are allowed."""
    runs = 4000 if IS_THOROUGH else 400
    bad = []
    for name, size, can_tell, z in rows_of_table(rng, number, runs):
        if IS_THOROUGH:
            print(f"{name:28} {size:7.4f} {len(z) / runs:6.3f} {rms(z) if len(z) else np.nan:6.2f}")
        if can_tell and len(z) >= LEAST_SHARE * runs and rms(z) > RESOLVED_RMS * (1 + 2 / np.sqrt(2 * len(z))):
            bad.append((name, size, len(z), rms(z)))
    assert not bad, bad


@pytest.mark.parametrize("numbers", [1, 4])
def test_false_alarms(rng, numbers):
    """Of 2000 runs without a drift, 5 % have a number that is said to drift. The largest of five errors makes drifts smaller for white
    noise, and few blocks make them larger: between 2 and 10 %."""
    samples = rng.normal(size=(1000, 2000 * numbers))
    drifts = np.abs(averages_of(samples).drifts()).reshape(2000, numbers)
    assert 0.02 < (drifts > _blocking.largest_drift(numbers)).any(axis=1).mean() < 0.1


def test_cautious(rng):
    """The error beside a drift covers the state at the end; that of equal numbers stays 0."""
    averages = averages_of(np.stack([rng.normal(size=1000) + np.linspace(1, 0, 1000), np.ones(1000)], axis=1))
    plain, found = averages.estimate(), averages.cautious()
    factor = _blocking.widening(plain.samples[0], averages.drifts()[0])
    assert factor > 6 and found.error[0] == pytest.approx(factor * plain.error[0], rel=1e-14)
    assert _blocking.widening(9, 0) == pytest.approx(1.25, rel=1e-14)  # 8 degrees of freedom: the error of the error is a quarter
    assert found.error[1] == 0 and (found.value == plain.value).all() and (found.samples == plain.samples).all()


def test_block_correlation():
    """The correlation of the averages of successive blocks, by sums over all pairs of many points of each."""
    points = (np.arange(1000) + 0.5) / 1000
    for length in (0.05, 1.0, 8.0):
        within = np.exp(-length * np.abs(points[:, None] - points)).mean()  # errs by length/6e6 of the midpoints, and by 1e-6 length²
        between = np.exp(-length * (1 + points[:, None] - points)).mean()
        assert _blocking._block_correlation(length) == pytest.approx(between / within, rel=3e-5)


def test_drifts(rng):
    """Of the order of one without a drift, and the difference from the start to the end over its error with one, also if the drift is so
    large that the run is too short for other errors."""
    for time in (0.1, 5.0):
        samples = correlated(rng, time, (1000, 400))[0]
        assert 0.85 < rms(averages_of(samples).drifts()) < 1.15
        slope = np.polyfit(np.arange(1000), samples, 1)[0] * 1000
        error = np.sqrt((1 + np.exp(-1 / time)) / (1 - np.exp(-1 / time)) / 1000)
        for added in (1.0, 100.0):
            line = np.linspace(0, added, 1000)[:, None]
            assert np.median(averages_of(samples + line).drifts() / (slope + added)) == pytest.approx(1 / (np.sqrt(12) * error), rel=0.2)
    assert np.isnan(averages_of(samples[:20]).drifts()).all() and np.isnan(pypw85.Blocking(2).drifts()).all()
    assert (averages_of(np.full(100, 0.1)).drifts() == 0).all()


@pytest.fixture
def reproducible():
    """The same walks on every processor."""
    pypw85.set_reproducible(True)
    yield
    pypw85.set_reproducible(False)


def test_errors_of_simulations(reproducible):
    """Few spheroids at constant pressure, in 100 runs: volume, directions, and pressure by chains, which share their blocks. The root mean
    square of 100 deviations has the error 1/√200 = 0.07; four such errors are allowed."""
    pressure, found = 0.6, []
    start = pypw85.pack(np.tile([0.5, 0.5, 1.0], (8, 1)), 0.2, seed=1)
    for seed in range(100):
        simulation = pypw85.HardEllipsoids(start, seed)
        simulation.set_steps(0.4, 0.4, 0.1)
        averages = pypw85.Blocking(3)
        for k in range(-16, 256):
            simulation.sweep(3)
            simulation.volume_moves(40, pressure)
            z = simulation.chain(2, 4.0)
            if k >= 0:
                along = 1 - 2 * (simulation.quaternions[:, 1:3] ** 2).sum(axis=1)
                averages.add([simulation.cell[0, 0] ** 3, along @ along, z])
        found.append(averages.estimate()[:2])
    values, errors = np.moveaxis(found, 1, 0)
    known = np.isfinite(errors[:, 0])
    assert known.mean() > 0.9
    for column in range(3):
        z = ((values - values.mean(axis=0)) / errors)[known, column]
        assert abs(rms(z) - 1) < 4 / np.sqrt(200), (column, rms(z))


def test_few_samples(rng):
    """Errors are unknown rather than too small; equal samples have none."""
    assert np.isnan(pypw85.Blocking().estimate()).all()
    averages = averages_of(rng.normal(size=31))
    assert np.isfinite(averages.estimate().value) and np.isnan(averages.estimate()[1:]).all()
    walk = averages_of(np.cumsum(rng.normal(size=200))).estimate()
    assert np.isnan(walk.error) and np.isnan(walk.samples)
    constant = averages_of(np.full(100, 0.1)).estimate()
    assert (constant.value, constant.error, constant.samples) == (0.1, 0, 100)


def test_restored_blocking(rng):
    samples = rng.normal(size=(50, 3))
    for count in (0, 1, 21):
        averages = pypw85.Blocking.restore(averages_of(samples[:count]).state())
        for sample in samples[count:]:
            averages.add(sample)
        assert np.array_equal(averages.state(), averages_of(samples).state())


def test_error_of_the_density_of_an_ideal_gas():
    """Points at constant pressure. With the density V^N exp(-βPV) of volumes, the mean of N/V is βP exactly."""
    pressure, within, samples = 5.0, 0, []
    places = 0.6 * np.stack(np.meshgrid(*[np.arange(2)] * 3), axis=-1).reshape(-1, 3)
    upright = np.tile([1.0, 0, 0, 0], (8, 1))
    start = pypw85.System.from_axes(places, np.full((8, 3), 1e-9), upright, cell=1.2 * np.eye(3))
    for seed in range(50):
        simulation = pypw85.HardEllipsoids(start, seed)
        simulation.set_steps(0.1, 0.1, 0.2)
        simulation.volume_moves(100, pressure)
        density = pypw85.Blocking()
        for _ in range(1000):
            simulation.volume_moves(2, pressure)
            density.add(8 / simulation.cell[0, 0] ** 3)
        found = density.estimate()
        within += int(abs(found.value[0] - pressure) < found.error[0])
        samples.append(found.samples[0])
    # 50 trials of 0.66 to 0.683: the probability of what is refused is 0.2 %
    assert 23 <= within <= 43, within
    # These samples are correlated: the errors of 1000 independent ones would be half as large.
    assert np.median(samples) < 400, samples


def test_equation_of_state_of_hard_spheres():
    """βP/ρ by event chains and by contacts, beside that of Carnahan and Starling."""
    phi, n = 0.3, 64
    expected = (1 + phi + phi**2 - phi**3) / (1 - phi) ** 3
    simulation = pypw85.HardEllipsoids(pypw85.pack(np.full((n, 3), 0.5), phi, seed=1), seed=1)
    simulation.set_fractions(translation=1)
    simulation.tune(50)
    observables = pypw85.Observables()
    for _ in range(300):
        simulation.sweep(2)
        sample = observables.add(simulation, simulation.chain(10, 4.0))
    assert len(observables) == 300
    found = observables.estimates()
    assert found["volume"].error == found["density"].error == 0
    assert found["packing_fraction"].value == pytest.approx(phi, rel=1e-14)
    assert sample.density == pytest.approx(6 * phi / np.pi, rel=1e-14)
    for name, largest_error in (("compressibility_chains", 0.04), ("compressibility_contacts", 0.2)):
        value, error, samples = found[name]
        assert 0 < error < largest_error and samples > 100
        assert abs(value - expected) < 4 * error, (name, value, error, expected)
    bias, error, _ = found["contacts_bias"]
    assert abs(bias) < 4 * error < 2


def test_bias_of_contacts():
    """The estimate that the bias is the fourth power of the width: pairs whose density in μ - 1 = e is e⁴."""
    width, n = 0.3, 4000
    points = (np.arange(n) + 0.5) / n * width
    weights = points**4 * width / n
    wide, narrow = (
        sum(w * (_observables.compressibility_of(np.array([e]), 1, part * width) - 1) for e, w in zip(points, weights)) for part in (1, 0.5)
    )
    # The density at contact is 0, so the whole value is the bias. The rule of midpoints errs by some 1e-6 of it.
    assert _observables._BIAS_BY_DIFFERENCE * (wide - narrow) == pytest.approx(wide, rel=1e-3)


def gas(rng, n, cell):
    """Particles as small as points, with random axes."""
    quaternions = rng.normal(size=(n, 4))
    return pypw85.System.from_axes(rng.uniform(size=(n, 3)) @ cell, np.tile([1e-9, 1e-9, 2e-9], (n, 1)), quaternions, cell=cell)


def test_pair_correlation_against_all_images(rng):
    """In a skewed cell that is smaller than the reach, one image at a time."""
    reach, bins, cell = 5.0, 7, CELL * 0.5
    system = gas(rng, 5, cell)
    observables = pypw85.Observables(reach=reach, bins=bins)
    observables.add(pypw85.HardEllipsoids(system))
    found = observables.pair_correlation()
    axes = np.array([pypw85.principal_axes(q)[1][:, 2] for q in system.q * 2.0**60])
    counts, weighted = np.zeros(bins), np.zeros(bins)
    for i, j in itertools.combinations(range(5), 2):
        for image in itertools.product(range(-5, 6), repeat=3):
            r = np.linalg.norm(system.centers[j] + image @ cell - system.centers[i])
            if r < reach:
                counts[int(r / reach * bins)] += 1
                weighted[int(r / reach * bins)] += 1.5 * (axes[i] @ axes[j]) ** 2 - 0.5
    ideal = 5 * 4 / 2 / np.linalg.det(cell) * 4 / 3 * np.pi * np.diff(found.edges**3)
    np.testing.assert_allclose(found.edges, np.linspace(0, reach, bins + 1), rtol=1e-15)
    np.testing.assert_allclose(found.g, counts / ideal, rtol=1e-13)
    np.testing.assert_allclose(found.p2[counts > 0], (weighted / counts)[counts > 0], rtol=0, atol=1e-7)
    assert np.isnan(found.g_error).all() and np.isnan(found.p2_error).all()
    assert counts[-1] > 100


def test_pair_correlation_of_an_ideal_gas(rng):
    """g is 1 and P2 is 0 at each distance, also beyond the cell, within four standard errors, which are those of counts."""
    observables = pypw85.Observables(reach=1.2, bins=6)
    for _ in range(200):
        observables.add(pypw85.HardEllipsoids(gas(rng, 20, np.eye(3))))
    found = observables.pair_correlation()
    assert (np.abs(found.g - 1) < 4 * found.g_error).all() and (np.abs(found.p2) < 4 * found.p2_error).all()
    pairs = 200 * 190 * 4 / 3 * np.pi * np.diff(found.edges**3)
    # P2 of random axes has the variance 1/5. Beyond half of the cell, images of one pair count together. The errors come from 25
    # blocks. So their relative standard deviation is 1/√48, of which 0.6 is four.
    inner = slice(0, 2)
    np.testing.assert_allclose(found.g_error[inner], pairs[inner] ** -0.5, rtol=0.6)
    np.testing.assert_allclose(found.p2_error[inner], (5 * pairs[inner]) ** -0.5, rtol=0.6)


def test_error_of_p2_of_parallel_axes(rng):
    """P2 is 1 without an error, however the numbers of pairs fluctuate."""
    observables = pypw85.Observables(reach=0.6, bins=2)
    for _ in range(70):
        axes = np.tile([1e-9, 1e-9, 2e-9], (9, 1))
        upright = pypw85.System.from_axes(rng.uniform(size=(9, 3)), axes, np.tile([1, 0, 0, 0], (9, 1)), cell=np.eye(3))
        observables.add(pypw85.HardEllipsoids(upright))
    found = observables.pair_correlation()
    assert (found.p2 == 1).all() and (found.p2_error < 1e-7).all() and (found.g_error > 0.01).all()


@pytest.mark.parametrize("axes, strength", [((0.1, 0.1, 0.3), 0.8), ((0.2, 0.2, 0.05), 0.8), ((0.1, 0.1, 0.3), 1e-3)])
def test_director(rng, axes, strength):
    """Rods and plates near an axis; the sign is that of the largest coordinate."""
    for along in ([0, 0, 1], [0.6, 0, -0.8], [-0.9, 0.1, 0.2], [0, -1, 0]):
        along = along / np.linalg.norm(along)
        # The half turn about the middle of z and the axis takes z there, and any turn about z does no harm.
        half = np.concatenate([[0], along + [0, 0, 1]])
        quaternions = np.tile(half, (200, 1)) + rng.normal(size=(200, 4)) * (1 - strength) * 0.2
        quaternions *= rng.choice([-1, 1], (200, 1))
        places = np.stack(np.unravel_index(np.arange(200), (6, 6, 6)), axis=-1)
        system = pypw85.System.from_axes(places, np.tile(axes, (200, 1)), quaternions, cell=6 * np.eye(3))
        found = pypw85.director(system)
        assert np.linalg.norm(found) == pytest.approx(1, abs=1e-14)
        assert found[np.abs(found).argmax()] > 0
        assert abs(found @ along) > 0.99
        dyads = 1.5 * np.mean([np.outer(u, u) for u in directions_of(system)], axis=0) - 0.5 * np.eye(3)
        assert found @ dyads @ found == pytest.approx(pypw85.nematic_order(system), abs=1e-12)
        observables = pypw85.Observables()
        sample = observables.add(pypw85.HardEllipsoids(system))
        assert sample.nematic_order == pytest.approx(pypw85.nematic_order(system), abs=1e-14)
        np.testing.assert_allclose(observables.director(), found, rtol=0, atol=1e-12)
        assert "compressibility_chains" not in observables.estimates()


def test_spheres_have_no_axes(rng):
    """Three parallel rods among spheres, which are turned at random: order, director and P2 are those of the rods."""
    for unit, small in itertools.product((1.0, 2.0**40, 2.0**-40), (0, 1e-8)):
        axes = unit * np.array(3 * [[0.1, 0.1, 0.3]] + 3 * [[0.2, 0.2, 0.2 * (1 + small)]])
        quaternions = np.concatenate([np.tile([1, 1, 0, 0], (3, 1)), rng.normal(size=(3, 4))])
        places = unit * np.array([[0.7, 0, 0], [0, 0.0, 0], [1.4, 0, 0], [0, 0, 1.2], [0, 1.2, 0], [0.7, 0.7, 1.4]])
        mixed = pypw85.System.from_axes(places, axes, quaternions, cell=2.5 * unit * np.eye(3))
        assert pypw85.nematic_order(mixed) == pytest.approx(1, abs=1e-14)
        assert pypw85.director(mixed) == pytest.approx([0, 1, 0], abs=1e-14)
        observables = pypw85.Observables(reach=0.8 * unit, bins=1)
        assert observables.add(pypw85.HardEllipsoids(mixed)).nematic_order == pytest.approx(1, abs=1e-14)
        found = observables.pair_correlation()
        assert found.p2 == pytest.approx([1], abs=1e-14) and found.g > 0
        spheres = pypw85.System.from_axes(places[3:], axes[3:], quaternions[3:], cell=mixed.cell)
        assert np.isnan(pypw85.nematic_order(spheres)) and np.isnan(pypw85.director(spheres)).all()
        observables = pypw85.Observables()
        for _ in range(40):
            observables.add(pypw85.HardEllipsoids(spheres))
        found = observables.estimates()
        assert "nematic_order" not in found and found["volume"].error == 0 and np.isnan(observables.director()).all()
        # No pair is within the width, which says nothing of the error.
        assert np.isnan(found["compressibility_contacts"].error) and found["compressibility_contacts"].value == 1
    assert np.isnan(pypw85.compressibility([[4.0], [9.0]], 3).error)
    for width in (1.5, 5):
        with pytest.raises(ValueError, match=f"^compressibility: width must be > 0 and at most 1, not {width}$"):
            pypw85.compressibility([[4.0], [9.0]], 3, width)


def directions_of(system):
    """The axes that differ most from the others, from the forms."""
    lengths, rotation = pypw85.principal_axes(system.q)
    chosen = np.where(lengths[:, 1] ** 2 <= lengths[:, 0] * lengths[:, 2], 2, 0)
    return rotation[np.arange(len(system)), :, chosen]


def test_refused_blocking(rng):
    """Sizes, samples and states that are none."""
    for size in (0, -1):
        with pytest.raises(ValueError, match=rf"^Blocking: size must be an integer from 1 to 2\*\*31 - 1, not {size}$"):
            pypw85.Blocking(size)
    for size in (None, 1.5):
        with pytest.raises(TypeError):
            pypw85.Blocking(size)
    averages = averages_of(rng.normal(size=(13, 2)))
    with pytest.raises(ValueError, match=r"the shape of the sample must be \(2,\), not \(3,\)"):
        averages.add([1, 2, 3])
    state = averages.state()
    changed = state.copy()
    changed[1, 0] += 1
    for bad in ([1, 2], state[:, :-1], state[1:, :-2], changed, np.full((1, 5), np.nan), np.full((1, 14), np.nan), np.full((1, 5), 0.5)):
        with pytest.raises(ValueError, match=r"^Blocking\.restore: the state must be that of state\(\)"):
            pypw85.Blocking.restore(bad)
    whole = pypw85.Observables().state()
    for bad in ({}, {**whole, "settings": np.ones(2)}, {"settings": whole["settings"]}, None):
        with pytest.raises(ValueError, match=r"^Observables\.restore: the state must be that of Observables\.state\(\)"):
            pypw85.Observables.restore(bad)
    with pytest.raises(ValueError, match=r"^Blocking\.restore: the state must be that of state\(\) for samples of 8 numbers"):
        pypw85.Observables.restore({**whole, "values": state})


def test_restored_observables(rng):
    """Averages go on bit by bit."""
    whole, first = (pypw85.Observables(0.2, 0.7, 3) for _ in range(2))
    states = [pypw85.HardEllipsoids(gas(rng, 4, np.eye(3))) for _ in range(9)]
    for state in states[:4]:
        first.add(state, 1.5)
    rest = pypw85.Observables.restore(first.state())
    for state in states[4:]:
        rest.add(state, 2.5)
    for k, state in enumerate(states):
        whole.add(state, 1.5 if k < 4 else 2.5)
    assert len(rest) == 9
    for name, numbers in whole.state().items():
        assert np.array_equal(numbers, rest.state()[name]), name


def test_refused(rng):
    widths = [("width", number) for number in (0.0, np.nan, np.inf, 1.5)]
    for name, number in (*widths, ("reach", -1.0), ("reach", np.inf), ("bins", 0)):
        with pytest.raises(ValueError, match=f"^Observables: {name} must be .*, not {number}$"):
            pypw85.Observables(**{name: number})
    with pytest.raises(TypeError):
        pypw85.Observables(bins=2.5)
    with pytest.raises(TypeError, match=r"^Observables\.add: simulation must be a pypw85\.HardEllipsoids, not System$"):
        pypw85.Observables().add(gas(rng, 3, np.eye(3)))
    observables = pypw85.Observables()
    assert observables.pair_correlation() is None and np.isnan(observables.director()).all() and observables.estimates() == {}
    with pytest.raises(ValueError, match="the simulation must have particles"):
        observables.add(pypw85.HardEllipsoids(gas(rng, 0, np.eye(3))))
    assert len(observables) == 0


@pytest.mark.parametrize("others", [{"cell": None}, {"cell": np.eye(3), "periodic": [True, True, False]}], ids=["no cell", "slit"])
def test_container(rng, others):
    """Where the cell is not the volume of the particles there are orders and energies alone."""
    given = gas(rng, 3, np.eye(3))
    simulation = pypw85.HardEllipsoids(pypw85.System.from_axes(given.centers, given.semi_axes, given.quaternions, **others))
    simulation.set_fields([pypw85.Field.linear([0, 0, 2])])
    observables = pypw85.Observables()
    sample = observables.add(simulation)
    assert sample.energy == simulation.energy() != 0
    assert {name for name, value in sample._asdict().items() if not np.isnan(value)} == {"nematic_order", "energy"}
    assert list(observables.estimates()) == ["nematic_order", "energy"] and not np.isnan(observables.director()).any()
    with pytest.raises(ValueError, match="pair correlation needs a cell that is periodic along its three vectors"):
        pypw85.Observables(reach=1.0).add(simulation)


def test_principal_directions(rng):
    """The columns of the rotation matrix for the axis that differs most from the middle one, with longer numbers, in any order of
    the axes and any unit."""
    quaternions = rng.normal(size=(60, 4))
    quaternions /= np.linalg.norm(quaternions, axis=1, keepdims=True)
    w, x, y, z = quaternions.T.astype(np.longdouble)
    rotations = np.array([
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ])  # fmt: skip
    norm = w * w + x * x + y * y + z * z
    for unit, axes in itertools.product((1.0, 2.0**40, 2.0**-40), itertools.permutations([1.0, 1.1, 2.5])):
        system = pypw85.System.from_axes(rng.normal(size=(60, 3)), np.tile(axes, (60, 1)) * unit, quaternions)
        expected = (rotations[:, axes.index(2.5)] / norm).T
        found = _statistics.principal_directions(system)
        # some ten operations on numbers up to 2, and the rounding of the quaternion's length
        np.testing.assert_allclose(found, expected.astype(float), rtol=0, atol=20 * 2.0**-53, err_msg=f"{unit.hex()} {axes}")
