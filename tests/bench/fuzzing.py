"""Run the fuzzers of all readers for a while, and count what they tried and found."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

DECODE = (
    "cargo",
    "run",
    "--quiet",
    "--release",
    "--manifest-path",
    "native/Cargo.toml",
    "--package",
    "decode",
)

FUZZERS = {
    "headers": (sys.executable, "-m", "tests.formats.fuzz_readers"),
    "geotiff": (*DECODE, "--example", "fuzz_geotiff", "--"),
    "text": (*DECODE, "--example", "fuzz_text", "--"),
}

TALLY = re.compile(r"([\d,]+) cases.*?([\d,]+) findings")


def fuzz_all(seconds: float) -> dict[str, float | str]:
    """Fuzz with each for so many seconds; a fuzzer that ends without a tally has broken down: a finding."""
    figures: dict[str, float | str] = {"fuzz_cases": 0, "fuzz_findings_open": 0}
    for name, command in FUZZERS.items():
        cases, findings = _fuzz(command, seconds)
        print(f"fuzzing: {name:34} {cases:11,} cases, {findings} findings")
        figures[f"fuzz_{name}_cases"] = cases
        figures["fuzz_cases"] = cases + int(figures["fuzz_cases"])
        figures["fuzz_findings_open"] = findings + int(figures["fuzz_findings_open"])
    return figures


def _fuzz(command: tuple[str, ...], seconds: float) -> tuple[int, int]:
    done = subprocess.run(
        [*command, "--seconds", f"{seconds:.0f}"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    tallies = TALLY.findall(done.stdout)
    if not tallies:
        print(f"{' '.join(command)} broke down ({done.returncode}):\n{done.stderr[-2000:]}", file=sys.stderr)
        return 0, 1
    cases, findings = (int(number.replace(",", "")) for number in tallies[-1])
    return cases, findings
