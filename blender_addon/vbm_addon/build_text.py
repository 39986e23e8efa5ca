# SPDX-License-Identifier: GPL-3.0-or-later
"""How a ball model came from its source, in one line that all results have."""


def line(report):
    """Of a model's report, as the library gives it or as `vbm_report` of an object keeps it:
    "Inside from normals; 1,021 samples added at a spacing of 0.09; 3 merged, 1 left out"."""
    report = report if hasattr(report, "keys") else report._asdict()
    added, merged, dropped = (int(report[name]) for name in ("added", "merged", "dropped"))
    parts = [f"Inside from {report['rule']}"]
    if added:
        parts.append(f"{added:,} sample{'s' * (added != 1)} added at a spacing of "
                     f"{report['spacing']:.3g}")
    left = [f"{merged:,} merged"] if merged else []
    left += [f"{dropped:,} left out"] if dropped else []
    return "; ".join(parts + ([", ".join(left)] if left else []))
