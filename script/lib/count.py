# SPDX-License-Identifier: GPL-3.0-or-later
"""Sums up: count.py SAME STYLE REPORT... prints "N passed, N failed, N skipped".

SAME and STYLE are 0 where the comparison of bytes and the style check passed; the rest are CTest's JUnit reports. A report that is not there, or has no tests, counts as a failure. Exits with 1
on failures.
"""

import sys
import xml.etree.ElementTree as ElementTree


def state(case):
    """What became of one test. CTest calls it skipped as well when its program was not built."""
    status = case.get("status")
    if status == "run":
        return "passed"
    skipped = case.find("skipped")
    said_so = skipped is not None and skipped.get("message", "").startswith("SKIP_")
    return "skipped" if status == "disabled" or said_so else "failed"


def count(path):
    """Passed, failed and skipped tests of one report."""
    try:
        cases = ElementTree.parse(path).getroot().findall("testcase")
    except (OSError, ElementTree.ParseError):
        cases = []
    if not cases:
        print(f"no tests were run: {path}")
        return 0, 1, 0
    states = [state(case) for case in cases]
    return states.count("passed"), states.count("failed"), states.count("skipped")


def main():
    failed = sum(word != "0" for word in sys.argv[1:3])
    passed, skipped = 2 - failed, 0
    for path in sys.argv[3:]:
        p, f, s = count(path)
        passed, failed, skipped = passed + p, failed + f, skipped + s
    print(f"{passed} passed, {failed} failed, {skipped} skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
