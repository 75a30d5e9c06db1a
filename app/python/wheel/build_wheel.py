"""Makes the wheel of the module: what pip and `python3 -m build` call (PEP 517).

CMake builds the module in build/wheel and installs it, with the libraries that it needs and that are
not those of every system, into a folder, which is packed.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]


def _project():
    text = (ROOT / "CMakeLists.txt").read_text()
    found = re.search(r'project\(cognate VERSION (\S+).*?DESCRIPTION "(.*?)"', text, re.DOTALL)
    return found.group(1), found.group(2)


def _metadata(version, summary):
    import numpy

    # An extension runs with the versions of numpy whose interface it was compiled against.
    major = int(numpy.__version__.split(".")[0])
    needs = "numpy>=1.22,<2" if major < 2 else "numpy>=1.25"
    lines = ["Metadata-Version: 2.1", "Name: cognate", f"Version: {version}", f"Summary: {summary}",
             "Requires-Python: >=3.9", f"Requires-Dist: {needs}",
             "Provides-Extra: frames", "Requires-Dist: pandas; extra == 'frames'"]
    return "\n".join(lines) + "\n"


def _cmake(*arguments):
    subprocess.run(["cmake", *map(str, arguments)], cwd=ROOT, check=True)


def _pybind11():
    """Where CMake finds pybind11 where it came by pip."""
    try:
        import pybind11
    except ImportError:
        return []
    return [f"-Dpybind11_DIR={pybind11.get_cmake_dir()}"]


def _build(folder):
    build = pathlib.Path(os.environ.get("COGNATE_WHEEL_BUILD", ROOT / "build" / "wheel"))
    launcher = shutil.which("ccache")
    _cmake("-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
           "-DBUILD_TESTING=OFF", "-DCOGNATE_BUILD_PYTHON=ON", f"-DPython3_EXECUTABLE={sys.executable}", "-DCOGNATE_PYTHON_DIR=.",
           f"-DCMAKE_CXX_COMPILER_LAUNCHER={launcher or ''}", *_pybind11())
    _cmake("--build", build, "--target", "cognate_python", "-j", os.cpu_count() or 1)
    for part in ("python", "python_libraries"):
        _cmake("--install", build, "--component", part, "--prefix", folder)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    from wheel.wheelfile import WheelFile

    version, summary = _project()
    abi = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    tag = f"{abi}-{abi}-{platform}"
    name = f"cognate-{version}-{tag}.whl"
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        _build(folder)
        info = folder / f"cognate-{version}.dist-info"
        info.mkdir()
        (info / "METADATA").write_text(_metadata(version, summary))
        (info / "WHEEL").write_text("Wheel-Version: 1.0\nGenerator: cognate\n"
                                    f"Root-Is-Purelib: false\nTag: {tag}\n")
        shutil.copy(ROOT / "LICENSE", info / "LICENSE")
        with WheelFile(str(pathlib.Path(wheel_directory) / name), "w") as wheel:
            wheel.write_files(str(folder))
    return name


def get_requires_for_build_wheel(config_settings=None):
    """pybind11 of the system serves; pip brings it where there is none."""
    known = [pathlib.Path(prefix, "cmake", "pybind11") for prefix in ("/usr/lib", "/usr/share")]
    return [] if any(path.is_dir() for path in known) else ["pybind11>=2.10"]


def build_sdist(sdist_directory, config_settings=None):
    version, summary = _project()
    name = f"cognate-{version}"
    path = pathlib.Path(sdist_directory) / f"{name}.tar.gz"
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, capture_output=True, text=True)
    with tempfile.NamedTemporaryFile("w", suffix="PKG-INFO") as metadata, \
            tarfile.open(path, "w:gz", format=tarfile.PAX_FORMAT) as archive:
        metadata.write(_metadata(version, summary))
        metadata.flush()
        archive.add(metadata.name, f"{name}/PKG-INFO")
        for file in listed.stdout.splitlines():
            archive.add(ROOT / file, f"{name}/{file}", recursive=False)
    return path.name
