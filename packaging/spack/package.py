# Not yet run.
from spack.package import *
from spack_repo.builtin.build_systems.meson import MesonPackage


class Pw85(MesonPackage):
    """The contact function of Perram and Wertheim for two ellipsoids: overlaps, distances, contacts, forces, Monte Carlo."""

    homepage = "@HOMEPAGE@"
    url = "@ARCHIVE@"
    git = "@REPOSITORY@"

    maintainers(
        "@MAINTAINERS@",
    )
    license("BSD-3-Clause")

    version("@VERSION@", sha256="@ARCHIVE_SHA256@")

    variant("gsl", default=False, description="Brent's method from GSL, which makes the library a work under the GPL")
    variant("openmp", default=True, description="Threads in the functions of many pairs")
    variant("fortran", default=False, description="Fortran module")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("fortran", type="build", when="+fortran")
    depends_on("meson@1.0.1:", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("gsl", when="+gsl")
    depends_on("boost+math", type="build", when="~gsl")

    def meson_args(self):
        def feature(name, enabled):
            return f"-D{name}={'enabled' if enabled else 'disabled'}"

        options = [feature(name, self.spec.satisfies(f"+{name}")) for name in ("gsl", "openmp", "fortran")]
        return options + [feature(name, False) for name in ("gpu", "tests", "bench", "python")]
