#!/usr/bin/env python3
"""Print what the Python package asks for, one requirement a line.

    python scripts/requirements_of_package.py [EXTRA...]
"""

import sys
import tomllib
from pathlib import Path

project = tomllib.loads((Path(__file__).parents[1] / "pyproject.toml").read_text())["project"]
extras = project["optional-dependencies"]
print(*project["dependencies"], *(line for extra in sys.argv[1:] for line in extras[extra]), sep="\n")
