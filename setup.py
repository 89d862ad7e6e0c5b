"""Packages: each folder is found, those of derivations and of generated files under their names."""

from setuptools import find_packages, setup

FOLDERS = {
    "mechproof": "src/mechproof",
    "mechproof.kernels": "generated",
    "mechproof.derivations": "derivations",
}

setup(
    package_dir=FOLDERS,
    packages=[
        name
        for package, folder in FOLDERS.items()
        for name in (package, *(f"{package}.{found}" for found in find_packages(folder)))
    ],
)
