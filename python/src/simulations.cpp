// SPDX-License-Identifier: BSD-3-Clause
// Monte Carlo of hard ellipsoids. The Python layer converts and explains; what would read or write
// beyond an array is refused here.
#include <cstdint>
#include <vector>

#include <pw85.h>
#include <pw85_simulation.h>
#include <pw85_systems.h>

#include "arguments.hpp"
#include "calls.hpp"

namespace pypw85 {
namespace {

constexpr char const *capsule_name = "pw85_hard_ellipsoids";

pw85_hard_ellipsoids *simulation_of(PyObject *capsule)
{
    return static_cast<pw85_hard_ellipsoids *>(PyCapsule_GetPointer(capsule, capsule_name));
}

void destroy(PyObject *capsule) { pw85_hard_ellipsoids_destroy(simulation_of(capsule)); }

/// The status of a function of the simulation, for which other threads of Python do not wait; null
/// for another object.
template <class Function> PyObject *status_of(PyObject *capsule, Function const &function)
{
    pw85_hard_ellipsoids *const simulation = simulation_of(capsule);
    if (simulation == nullptr) return nullptr;
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = function(simulation);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

/// The data of a contiguous array of doubles of the given shape, as data_of().
double const *doubles(PyObject *array, npy_intp &rows, npy_intp columns)
{
    return static_cast<double const *>(data_of(array, NPY_DOUBLE, rows, columns, false));
}

/// An array of a simulation, which it keeps alive. It cannot be written to.
Reference view_of(double const *data, std::size_t rows, npy_intp columns, PyObject *owner)
{
    npy_intp const shape[] = {static_cast<npy_intp>(rows), columns};
    Reference array(PyArray_SimpleNewFromData(2, shape, NPY_DOUBLE, const_cast<double *>(data)));
    if (!array) return nullptr;
    auto *const object = reinterpret_cast<PyArrayObject *>(array.get());
    PyArray_CLEARFLAGS(object, NPY_ARRAY_WRITEABLE);
    if (PyArray_SetBaseObject(object, Py_NewRef(owner)) != 0) return nullptr;
    return array;
}

/// The simulation, its arrays, and along which vectors it is periodic; null on error.
PyObject *views_of(pw85_hard_ellipsoids const *simulation, PyObject *capsule)
{
    pw85_system const system = pw85_hard_ellipsoids_system(simulation);
    std::size_t const n = system.num_particles;
    Reference const centers = view_of(system.centers, n, 3, capsule);
    Reference const q = view_of(system.q, n, 6, capsule);
    Reference const semi_axes = view_of(pw85_hard_ellipsoids_semi_axes(simulation), n, 3, capsule);
    Reference const quaternions =
        view_of(pw85_hard_ellipsoids_quaternions(simulation), n, 4, capsule);
    Reference const cell = system.cell == nullptr ? Reference(Py_NewRef(Py_None))
                                                  : view_of(system.cell, 3, 3, capsule);
    if (!centers || !q || !semi_axes || !quaternions || !cell) return nullptr;
    return Py_BuildValue("(OOOOOO(iii))", capsule, centers.get(), q.get(), semi_axes.get(),
                         quaternions.get(), cell.get(), system.periodic[0], system.periodic[1],
                         system.periodic[2]);
}

/// What create and restore return.
PyObject *made(int status, std::int32_t const *pair, pw85_hard_ellipsoids *simulation)
{
    if (status != PW85_SUCCESS) return Py_BuildValue("i(ii)O", status, pair[0], pair[1], Py_None);
    Reference const capsule(PyCapsule_New(simulation, capsule_name, destroy));
    if (!capsule) {
        pw85_hard_ellipsoids_destroy(simulation);
        return nullptr;
    }
    Reference const views(views_of(simulation, capsule.get()));
    if (!views) return nullptr;
    return Py_BuildValue("i(ii)O", status, pair[0], pair[1], views.get());
}

/// A number of a kind or an axis; -1, which is none, for others.
int number_of(double x) { return x >= 0.0 && x < 100.0 ? static_cast<int>(x) : -1; }

/// Rows of numbers as walls or fields: kind and, for fields, axis; point, vector, size or strength.
pw85_wall wall_of(double const *row)
{
    return {number_of(row[0]), {row[2], row[3], row[4]}, {row[5], row[6], row[7]}, row[8]};
}

pw85_field field_of(double const *row)
{
    return {number_of(row[0]),
            number_of(row[1]),
            {row[2], row[3], row[4]},
            {row[5], row[6], row[7]},
            row[8]};
}

template <class Element>
std::vector<Element> elements_of(double const *rows, npy_intp n, Element (*read)(double const *))
{
    std::vector<Element> elements;
    for (npy_intp k = 0; k < n; ++k) elements.push_back(read(rows + 9 * k));
    return elements;
}

} // namespace

PyObject *hard_ellipsoids_create(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    npy_intp n = -1, three = 3;
    if (!right_number(nargs, 6)) return nullptr;
    double const *const centers = doubles(args[0], n, 3);
    double const *const semi_axes = centers == nullptr ? nullptr : doubles(args[1], n, 3);
    double const *const quaternions = semi_axes == nullptr ? nullptr : doubles(args[2], n, 4);
    if (quaternions == nullptr) return nullptr;
    pw85_system system{static_cast<std::size_t>(n), centers, nullptr, nullptr, {0, 0, 0}};
    if (args[3] != Py_None) {
        system.cell = doubles(args[3], three, 3);
        if (system.cell == nullptr) return nullptr;
    }
    auto const *const periodic =
        static_cast<std::int32_t const *>(data_of(args[4], NPY_INT32, three, 0, false));
    if (periodic == nullptr) return nullptr;
    for (int k = 0; k < 3; ++k) system.periodic[k] = periodic[k];
    std::size_t const seed = PyLong_AsSize_t(args[5]);
    if (PyErr_Occurred()) return nullptr;
    int status;
    std::int32_t pair[2];
    pw85_hard_ellipsoids *simulation;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_hard_ellipsoids_create(&system, semi_axes, quaternions, seed, pair, &simulation);
    Py_END_ALLOW_THREADS;
    return made(status, pair, simulation);
}

PyObject *hard_ellipsoids_restore(PyObject *, PyObject *bytes)
{
    char *data;
    Py_ssize_t size;
    if (PyBytes_AsStringAndSize(bytes, &data, &size) != 0) return nullptr;
    int status;
    std::int32_t const pair[2] = {-1, -1};
    pw85_hard_ellipsoids *simulation;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_hard_ellipsoids_restore(
        static_cast<std::size_t>(size), reinterpret_cast<unsigned char const *>(data), &simulation);
    Py_END_ALLOW_THREADS;
    return made(status, pair, simulation);
}

PyObject *hard_ellipsoids_save(PyObject *, PyObject *capsule)
{
    pw85_hard_ellipsoids const *const simulation = simulation_of(capsule);
    if (simulation == nullptr) return nullptr;
    std::size_t const size = pw85_hard_ellipsoids_num_bytes(simulation);
    Reference bytes(PyBytes_FromStringAndSize(nullptr, static_cast<Py_ssize_t>(size)));
    if (!bytes) return nullptr;
    auto *const data = reinterpret_cast<unsigned char *>(PyBytes_AsString(bytes.get()));
    int const status = pw85_hard_ellipsoids_save(simulation, size, data);
    return Py_BuildValue("iN", status, bytes.release());
}

PyObject *hard_ellipsoids_sweep(PyObject *, PyObject *capsule)
{
    return status_of(capsule,
                     [](auto *simulation) { return pw85_hard_ellipsoids_sweep(simulation, 1); });
}

PyObject *hard_ellipsoids_volume_move(PyObject *, PyObject *args)
{
    PyObject *capsule;
    double pressure;
    int change;
    if (!PyArg_ParseTuple(args, "Odi", &capsule, &pressure, &change)) return nullptr;
    return status_of(capsule, [&](auto *simulation) {
        return pw85_hard_ellipsoids_volume_moves(simulation, 1, pressure, change);
    });
}

PyObject *hard_ellipsoids_tune(PyObject *, PyObject *args)
{
    PyObject *capsule;
    double acceptance, pressure;
    int change;
    if (!PyArg_ParseTuple(args, "Oddi", &capsule, &acceptance, &pressure, &change)) return nullptr;
    return status_of(capsule, [&](auto *simulation) {
        return pw85_hard_ellipsoids_tune(simulation, 1, acceptance, pressure, change);
    });
}

PyObject *hard_ellipsoids_set_fractions(PyObject *, PyObject *args)
{
    PyObject *capsule;
    double fractions[4];
    if (!PyArg_ParseTuple(args, "Odddd", &capsule, fractions, fractions + 1, fractions + 2,
                          fractions + 3))
        return nullptr;
    return status_of(capsule, [&](auto *simulation) {
        return pw85_hard_ellipsoids_set_fractions(simulation, fractions);
    });
}

PyObject *hard_ellipsoids_set_steps(PyObject *, PyObject *args)
{
    PyObject *capsule;
    double steps[3];
    if (!PyArg_ParseTuple(args, "Oddd", &capsule, steps, steps + 1, steps + 2)) return nullptr;
    return status_of(capsule, [&](auto *simulation) {
        return pw85_hard_ellipsoids_set_steps(simulation, steps);
    });
}

PyObject *hard_ellipsoids_set_dimensions(PyObject *, PyObject *args)
{
    PyObject *capsule;
    int dimensions;
    if (!PyArg_ParseTuple(args, "Oi", &capsule, &dimensions)) return nullptr;
    return status_of(capsule, [&](auto *simulation) {
        return pw85_hard_ellipsoids_set_dimensions(simulation, dimensions);
    });
}

PyObject *hard_ellipsoids_dimensions(PyObject *, PyObject *capsule)
{
    pw85_hard_ellipsoids const *const simulation = simulation_of(capsule);
    if (simulation == nullptr) return nullptr;
    int dimensions;
    pw85_hard_ellipsoids_dimensions(simulation, &dimensions);
    return PyLong_FromLong(dimensions);
}

PyObject *hard_ellipsoids_steps(PyObject *, PyObject *capsule)
{
    pw85_hard_ellipsoids const *const simulation = simulation_of(capsule);
    if (simulation == nullptr) return nullptr;
    double steps[3];
    pw85_hard_ellipsoids_steps(simulation, steps);
    return Py_BuildValue("ddd", steps[0], steps[1], steps[2]);
}

PyObject *hard_ellipsoids_counts(PyObject *, PyObject *capsule)
{
    pw85_hard_ellipsoids const *const simulation = simulation_of(capsule);
    if (simulation == nullptr) return nullptr;
    std::int64_t trials[5], accepted[5];
    pw85_hard_ellipsoids_counts(simulation, trials, accepted);
    Reference counts(PyTuple_New(5));
    for (int k = 0; counts && k < 5; ++k) {
        PyObject *const pair = Py_BuildValue("LL", static_cast<long long>(trials[k]),
                                             static_cast<long long>(accepted[k]));
        if (pair == nullptr) return nullptr;
        PyTuple_SetItem(counts.get(), k, pair);
    }
    return counts.release();
}

PyObject *hard_ellipsoids_chain(PyObject *, PyObject *args)
{
    PyObject *capsule, *vector;
    Py_ssize_t number;
    double length, direction[3], compressibility = 0;
    if (!PyArg_ParseTuple(args, "OndO", &capsule, &number, &length, &vector)) return nullptr;
    if (vector != Py_None &&
        !PyArg_ParseTuple(vector, "ddd", direction, direction + 1, direction + 2))
        return nullptr;
    pw85_hard_ellipsoids *const simulation = simulation_of(capsule);
    if (simulation == nullptr) return nullptr;
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_hard_ellipsoids_chain(simulation, static_cast<std::size_t>(number), length,
                                        vector == Py_None ? nullptr : direction, &compressibility);
    Py_END_ALLOW_THREADS;
    return Py_BuildValue("id", status, compressibility);
}

PyObject *hard_ellipsoids_neighbors(PyObject *, PyObject *args)
{
    PyObject *capsule;
    Py_ssize_t particle;
    if (!PyArg_ParseTuple(args, "On", &capsule, &particle)) return nullptr;
    pw85_hard_ellipsoids *const simulation = simulation_of(capsule);
    if (simulation == nullptr) return nullptr;
    auto const index = static_cast<std::size_t>(particle);
    std::size_t count;
    int status =
        pw85_hard_ellipsoids_neighbors(simulation, index, 0, &count, nullptr, nullptr, nullptr);
    npy_intp const shape[] = {static_cast<npy_intp>(count), 3};
    Reference const particles(PyArray_SimpleNew(1, shape, NPY_INT32)),
        images(PyArray_SimpleNew(2, shape, NPY_INT32)),
        separations(PyArray_SimpleNew(2, shape, NPY_DOUBLE));
    if (!particles || !images || !separations) return nullptr;
    auto const data = [](Reference const &array) {
        return PyArray_DATA(reinterpret_cast<PyArrayObject *>(array.get()));
    };
    if (status == PW85_SUCCESS)
        status = pw85_hard_ellipsoids_neighbors(
            simulation, index, count, &count, static_cast<std::int32_t *>(data(particles)),
            static_cast<std::int32_t *>(data(images)), static_cast<double *>(data(separations)));
    return Py_BuildValue("i(OOO)", status, particles.get(), images.get(), separations.get());
}

PyObject *hard_ellipsoids_try(PyObject *, PyObject *args)
{
    PyObject *capsule, *place, *turn;
    Py_ssize_t particle;
    int take, is_free = -1, status;
    double center[3], quaternion[4];
    if (!PyArg_ParseTuple(args, "OnOOp", &capsule, &particle, &place, &turn, &take)) return nullptr;
    if (place != Py_None && !PyArg_ParseTuple(place, "ddd", center, center + 1, center + 2))
        return nullptr;
    if (turn != Py_None &&
        !PyArg_ParseTuple(turn, "dddd", quaternion, quaternion + 1, quaternion + 2, quaternion + 3))
        return nullptr;
    pw85_hard_ellipsoids *const simulation = simulation_of(capsule);
    if (simulation == nullptr) return nullptr;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_hard_ellipsoids_try(simulation, static_cast<std::size_t>(particle),
                                      place == Py_None ? nullptr : center,
                                      turn == Py_None ? nullptr : quaternion, take, &is_free);
    Py_END_ALLOW_THREADS;
    return Py_BuildValue("ii", status, is_free);
}

PyObject *hard_ellipsoids_views(PyObject *, PyObject *capsule)
{
    pw85_hard_ellipsoids const *const simulation = simulation_of(capsule);
    return simulation == nullptr ? nullptr : views_of(simulation, capsule);
}

PyObject *hard_ellipsoids_set_walls(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    npy_intp n = -1;
    if (!right_number(nargs, 2)) return nullptr;
    double const *const rows = doubles(args[1], n, 9);
    pw85_hard_ellipsoids *const simulation = rows == nullptr ? nullptr : simulation_of(args[0]);
    if (simulation == nullptr) return nullptr;
    auto const walls = elements_of(rows, n, wall_of);
    int status;
    std::int32_t overlap[2];
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_hard_ellipsoids_set_walls(simulation, walls.size(), walls.data(), overlap);
    Py_END_ALLOW_THREADS;
    return Py_BuildValue("i(ii)", status, overlap[0], overlap[1]);
}

PyObject *hard_ellipsoids_set_mesh(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    npy_intp num_vertices = -1, num_triangles = -1;
    if (!right_number(nargs, 3)) return nullptr;
    double const *const vertices = doubles(args[1], num_vertices, PW85_DIM);
    if (vertices == nullptr) return nullptr;
    auto const *const triangles = data_of(args[2], NPY_INT32, num_triangles, 3, false);
    pw85_hard_ellipsoids *const simulation =
        triangles == nullptr ? nullptr : simulation_of(args[0]);
    if (simulation == nullptr) return nullptr;
    int status;
    std::int32_t overlap[2];
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_hard_ellipsoids_set_mesh(simulation, static_cast<std::size_t>(num_vertices),
                                           vertices, static_cast<std::size_t>(num_triangles),
                                           static_cast<std::int32_t const *>(triangles), overlap);
    Py_END_ALLOW_THREADS;
    return Py_BuildValue("i(ii)", status, overlap[0], overlap[1]);
}

PyObject *hard_ellipsoids_set_fields(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    npy_intp n = -1;
    if (!right_number(nargs, 2)) return nullptr;
    double const *const rows = doubles(args[1], n, 9);
    if (rows == nullptr) return nullptr;
    auto const fields = elements_of(rows, n, field_of);
    return status_of(args[0], [&](auto *simulation) {
        return pw85_hard_ellipsoids_set_fields(simulation, fields.size(), fields.data());
    });
}

PyObject *hard_ellipsoids_set_law(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    npy_intp n = -1;
    if (!right_number(nargs, 3)) return nullptr;
    long const kind = args[1] == Py_None ? 0 : PyLong_AsLong(args[1]);
    if (PyErr_Occurred()) return nullptr;
    auto const *const parameters =
        static_cast<double const *>(data_of(args[2], NPY_DOUBLE, n, 0, false));
    if (parameters == nullptr) return nullptr;
    pw85_law const law = {static_cast<int>(kind), static_cast<std::size_t>(n), parameters};
    return status_of(args[0], [&](auto *simulation) {
        return pw85_hard_ellipsoids_set_law(simulation, args[1] == Py_None ? nullptr : &law);
    });
}

PyObject *hard_ellipsoids_set_kind_steps(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    npy_intp n = -1;
    if (!right_number(nargs, 3)) return nullptr;
    double const *const axes = doubles(args[1], n, 3);
    double const *const steps = axes == nullptr ? nullptr : doubles(args[2], n, 2);
    if (steps == nullptr) return nullptr;
    return status_of(args[0], [&](auto *simulation) {
        return pw85_hard_ellipsoids_set_kind_steps(simulation, static_cast<std::size_t>(n), axes,
                                                   steps);
    });
}

PyObject *hard_ellipsoids_kind_steps(PyObject *, PyObject *args)
{
    PyObject *capsule;
    double axes[3], steps[2];
    if (!PyArg_ParseTuple(args, "O(ddd)", &capsule, axes, axes + 1, axes + 2)) return nullptr;
    pw85_hard_ellipsoids const *const simulation = simulation_of(capsule);
    if (simulation == nullptr) return nullptr;
    pw85_hard_ellipsoids_kind_steps(simulation, 1, axes, steps);
    return Py_BuildValue("dd", steps[0], steps[1]);
}

PyObject *hard_ellipsoids_set_potential(PyObject *, PyObject *args)
{
    PyObject *capsule, *function, *context;
    if (!PyArg_ParseTuple(args, "OOO", &capsule, &function, &context)) return nullptr;
    void *const address = PyLong_AsVoidPtr(function), *const first = PyLong_AsVoidPtr(context);
    if (PyErr_Occurred()) return nullptr;
    return status_of(capsule, [&](auto *simulation) {
        return pw85_hard_ellipsoids_set_potential(
            simulation, reinterpret_cast<pw85_potential *>(address), first);
    });
}

/// The status and the number of a function of the state of a simulation.
static PyObject *number_of(PyObject *capsule,
                           int (*function)(pw85_hard_ellipsoids const *, double *))
{
    pw85_hard_ellipsoids const *const simulation = simulation_of(capsule);
    if (simulation == nullptr) return nullptr;
    int status;
    double number;
    Py_BEGIN_ALLOW_THREADS;
    status = function(simulation, &number);
    Py_END_ALLOW_THREADS;
    return Py_BuildValue("id", status, number);
}

PyObject *hard_ellipsoids_energy(PyObject *, PyObject *capsule)
{
    return number_of(capsule, pw85_hard_ellipsoids_energy);
}

PyObject *hard_ellipsoids_law_virial(PyObject *, PyObject *capsule)
{
    return number_of(capsule, pw85_hard_ellipsoids_law_virial);
}

PyObject *hard_ellipsoids_insert(PyObject *, PyObject *args)
{
    PyObject *capsule;
    double center[3], turn[4], axes[3];
    int take, is_free, status;
    if (!PyArg_ParseTuple(args, "O(ddd)(dddd)(ddd)p", &capsule, center, center + 1, center + 2,
                          turn, turn + 1, turn + 2, turn + 3, axes, axes + 1, axes + 2, &take))
        return nullptr;
    pw85_hard_ellipsoids *const simulation = simulation_of(capsule);
    if (simulation == nullptr) return nullptr;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_hard_ellipsoids_insert(simulation, center, turn, axes, take, &is_free);
    Py_END_ALLOW_THREADS;
    return Py_BuildValue("ii", status, is_free);
}

PyObject *hard_ellipsoids_remove(PyObject *, PyObject *args)
{
    PyObject *capsule;
    Py_ssize_t particle;
    if (!PyArg_ParseTuple(args, "On", &capsule, &particle)) return nullptr;
    return status_of(capsule, [&](auto *simulation) {
        return pw85_hard_ellipsoids_remove(simulation, static_cast<std::size_t>(particle));
    });
}

PyObject *hard_ellipsoids_insertion_weight(PyObject *, PyObject *args)
{
    PyObject *capsule;
    Py_ssize_t number;
    double axes[3], weight;
    int status;
    if (!PyArg_ParseTuple(args, "On(ddd)", &capsule, &number, axes, axes + 1, axes + 2))
        return nullptr;
    pw85_hard_ellipsoids *const simulation = simulation_of(capsule);
    if (simulation == nullptr) return nullptr;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_hard_ellipsoids_insertion_weight(simulation, static_cast<std::size_t>(number),
                                                   axes, &weight);
    Py_END_ALLOW_THREADS;
    return Py_BuildValue("id", status, weight);
}

PyObject *hard_ellipsoids_insertion_moves(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    npy_intp n = -1;
    if (!right_number(nargs, 4)) return nullptr;
    Py_ssize_t const number = PyLong_AsSsize_t(args[1]);
    if (PyErr_Occurred()) return nullptr;
    double const *const axes = doubles(args[2], n, 3);
    double const *const activities = axes == nullptr ? nullptr : doubles(args[3], n, 0);
    pw85_hard_ellipsoids *const simulation =
        activities == nullptr ? nullptr : simulation_of(args[0]);
    if (simulation == nullptr) return nullptr;
    int status;
    std::int64_t counts[4];
    Py_BEGIN_ALLOW_THREADS;
    status =
        pw85_hard_ellipsoids_insertion_moves(simulation, static_cast<std::size_t>(number),
                                             static_cast<std::size_t>(n), axes, activities, counts);
    Py_END_ALLOW_THREADS;
    auto const large = [](std::int64_t count) { return static_cast<long long>(count); };
    return Py_BuildValue("i(LLLL)", status, large(counts[0]), large(counts[1]), large(counts[2]),
                         large(counts[3]));
}

PyObject *hard_ellipsoids_compress(PyObject *, PyObject *args)
{
    PyObject *capsule;
    int take, status;
    double factor = 0;
    if (!PyArg_ParseTuple(args, "Op", &capsule, &take)) return nullptr;
    pw85_hard_ellipsoids *const simulation = simulation_of(capsule);
    if (simulation == nullptr) return nullptr;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_hard_ellipsoids_compress(simulation, take, &factor);
    Py_END_ALLOW_THREADS;
    return Py_BuildValue("id", status, factor);
}

PyObject *hard_ellipsoids_check(PyObject *, PyObject *capsule)
{
    pw85_hard_ellipsoids const *const simulation = simulation_of(capsule);
    if (simulation == nullptr) return nullptr;
    int status;
    std::int32_t pair[2];
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_hard_ellipsoids_check(simulation, pair);
    Py_END_ALLOW_THREADS;
    return Py_BuildValue("i(ii)", status, pair[0], pair[1]);
}

} // namespace pypw85
