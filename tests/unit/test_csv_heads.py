"""Headers of CSV files, in comments or not, are found beside other signs."""

from __future__ import annotations

from pathlib import Path

import pytest

from ropewalk.scene.csv_columns import read_columns


@pytest.mark.parametrize(
    "head",
    [
        "# strain [%], tension [kN]; specimen 3\n",
        "strain [%], tension [kN];\n",
        "strain [%],\ttension [kN]\n",
        "# load cell of 50 (kN)\n# strain [%], tension [kN]\n",
        "# strain [%], tension [kN]\n# load cell of 50 (kN)\n",
    ],
)
def test_signs_beside_commas_hide_no_header(tmp_path: Path, head: str) -> None:
    """With a semicolon in its comment a curve lost its header, and had its columns swapped."""
    (tmp_path / "curve.csv").write_text(head + "0,0\n1,0.02\n")
    columns = {"tension": "N", "strain": "1"}
    assert read_columns(tmp_path, "curve.csv", columns) == [[0.0, 20.0], [0.0, 0.01]]
