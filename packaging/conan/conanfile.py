# SPDX-License-Identifier: Apache-2.0
"""The core and the simulation for Conan 2: conan create packaging/conan

Files, pictures and the tool need libraries that are not required here, and are left out.
"""

import pathlib

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy

PARTS = ("APPS", "SERVER", "REPRODUCTION", "PHYSICS", "TESTS", "EXAMPLES", "ROS", "PYTHON")


class FairwayRecipe(ConanFile):
    name = "fairway"
    version = "0.1.0"
    license = "Apache-2.0"
    description = "Safe corridors and model predictive control for wheeled robots"
    settings = "os", "compiler", "build_type", "arch"
    package_type = "static-library"
    generators = "CMakeDeps"

    def export_sources(self):
        root = pathlib.Path(self.recipe_folder).parents[1]
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "src/*", "packaging/*", "experiments/*", "viewer/page.html"):
            copy(self, pattern, str(root), self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def validate(self):
        check_min_cppstd(self, 20)

    def requirements(self):
        self.requires("eigen/3.4.0", transitive_headers=True)
        self.requires("tl-expected/1.1.0", transitive_headers=True)

    def generate(self):
        toolchain = CMakeToolchain(self)
        for part in PARTS:
            toolchain.cache_variables[f"FAIRWAY_BUILD_{part}"] = False
        toolchain.cache_variables["FAIRWAY_COMPILER_CACHE"] = False
        for library in ("yaml-cpp", "PkgConfig"):
            toolchain.cache_variables[f"CMAKE_DISABLE_FIND_PACKAGE_{library}"] = True
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        self.cpp_info.set_property("cmake_find_mode", "none")  # the installed CMake package is used
        self.cpp_info.builddirs = ["lib/cmake/fairway"]
