"""Links the archive of the board's core; PlatformIO runs this for each project that uses the library."""

import os
import sys

Import("env")  # noqa: F821

FOLDERS = {
    "cortex-m0": "cortex-m0",
    "cortex-m0plus": "cortex-m0plus",
    "cortex-m4": os.path.join("cortex-m4", "fpv4-sp-d16-hard"),
    "esp32c6": "esp32c6",
    "esp32h2": "esp32h2",
    "esp32c3": "esp32c3",
}

board = env.BoardConfig() if "BOARD" in env else {}  # noqa: F821
core = board.get("build.cpu", "") or board.get("build.mcu", "")
folder = "host" if env["PIOPLATFORM"] == "native" else FOLDERS.get(core)  # noqa: F821
if folder is None:
    sys.exit("microwarp: no archive for the core '%s'; there are: %s" % (core, ", ".join(sorted(FOLDERS))))
source = os.path.join(Dir(".").srcnode().abspath, "src", folder)  # noqa: F821
# The environment of the project, which links; `env` is that of the library.
DefaultEnvironment().Append(LIBPATH=[source], LIBS=["microwarp"])  # noqa: F821
