# Not yet run.
from conan import ConanFile
from conan.tools.build import check_min_cppstd, stdcpp_library
from conan.tools.files import copy, get
from conan.tools.gnu import PkgConfigDeps
from conan.tools.layout import basic_layout
from conan.tools.meson import Meson, MesonToolchain

required_conan_version = ">=2.0"


class Pw85Recipe(ConanFile):
    name = "pw85"
    version = "@VERSION@"
    description = "The contact function of Perram and Wertheim for two ellipsoids"
    license = "BSD-3-Clause"
    homepage = "@HOMEPAGE@"
    url = "@REPOSITORY@"
    topics = ("ellipsoids", "overlap", "contact", "simulation")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False]}
    default_options = {"shared": False, "fPIC": True}

    def validate(self):
        check_min_cppstd(self, 20)

    def _has_openmp(self):
        """Apple's compiler has no OpenMP of its own."""
        return self.settings.compiler in ("gcc", "clang")

    def requirements(self):
        self.requires("boost/[>=1.74 <2]", options={"header_only": True}, headers=True, libs=False)

    def build_requirements(self):
        self.tool_requires("meson/[>=1.0.1 <2]")
        self.tool_requires("pkgconf/[>=2 <3]")

    def layout(self):
        basic_layout(self, src_folder="src")

    def source(self):
        get(self, **self.conan_data["sources"][self.version], strip_root=True)

    def generate(self):
        toolchain = MesonToolchain(self)
        toolchain.project_options["openmp"] = "enabled" if self._has_openmp() else "disabled"
        toolchain.project_options.update(dict.fromkeys(["gsl", "gpu", "tests", "bench", "python", "fortran"], "disabled"))
        toolchain.generate()
        PkgConfigDeps(self).generate()

    def build(self):
        meson = Meson(self)
        meson.configure()
        meson.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, f"{self.package_folder}/licenses")
        Meson(self).install()

    def package_info(self):
        for name, requires in (("pw85", []), ("pw85_legacy", ["pw85"]), ("pw85_gpu", ["pw85"])):
            component = self.cpp_info.components[name]
            component.libs = [name]
            component.requires = requires or ["boost::headers"]
            component.set_property("pkg_config_name", name)
            component.set_property("cmake_target_name", f"pw85::{name}")
            component.system_libs = ["m", "dl"] if self.settings.os == "Linux" else []
            if not self.options.shared:
                self._link_in_any_language(component)

    def _link_in_any_language(self, component):
        """What a program in C needs to link the static library, which is C++ with OpenMP."""
        component.system_libs.append(stdcpp_library(self))
        if self._has_openmp():
            component.exelinkflags = component.sharedlinkflags = ["-fopenmp"]
