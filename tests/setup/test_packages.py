# SPDX-License-Identifier: GPL-3.0-or-later
"""apt_install.sh, with stand-ins for the programs that would change the machine."""

import os
import pathlib
import subprocess

import pytest

SCRIPT = pathlib.Path(__file__).parents[2] / "libvbm/cmake/apt_install.sh"


class Machine:
    """A PATH of its own, in which some packages are installed and every call is written down."""

    def __init__(self, folder):
        self.folder = folder
        self.calls = folder / "calls"
        for tool in ("sed", "tr", "mktemp", "rm", "tail", "env", "cat", "grep"):
            (folder / tool).symlink_to(f"/usr/bin/{tool}")
        self.program("id", "echo 0")
        self.program("dpkg-query", 'for last; do :; done; case "$last" in have*) printf "installed ";; '
                                   'removed) printf "config-files ";; *) exit 1;; esac')
        self.program("apt-get", f'echo "$@ [$DEBIAN_FRONTEND]" >>"{self.calls}"')
        self.list = folder / "packages.txt"
        self.list.write_text("# a comment\nhave-one\nremoved  # and why\n\nmissing-one\n")

    def program(self, name, body):
        path = self.folder / name
        path.unlink(missing_ok=True)
        path.write_text(f"#!/bin/sh\n{body}\n")
        path.chmod(0o755)

    def run(self, *lists):
        done = subprocess.run(["/bin/sh", SCRIPT, *(lists or [self.list])], env={"PATH": str(self.folder)},
                              capture_output=True, text=True)
        calls = self.calls.read_text().splitlines() if self.calls.exists() else []
        return done, calls


@pytest.fixture
def machine(tmp_path):
    return Machine(tmp_path)


def test_only_what_is_missing(machine):
    done, calls = machine.run()
    assert done.returncode == 0, done.stderr
    assert len(calls) == 2 and "--simulate" in calls[0]
    assert calls[1].endswith(" removed missing-one [noninteractive]")
    assert "--no-install-recommends" in calls[1] and "update" not in calls[1]


def test_nothing_missing_calls_nothing(machine):
    machine.list.write_text("have-one\nhave-two\n")
    done, calls = machine.run()
    assert done.returncode == 0 and not calls and not done.stdout


def test_index_is_fetched_when_it_is_not_known(machine):
    machine.program("apt-get", f'echo "$1" >>"{machine.calls}"; known="{machine.folder}/known"\n'
                               'case "$1" in update) : >"$known";; *) [ -e "$known" ];; esac')
    done, calls = machine.run()
    assert done.returncode == 0, done.stderr
    assert calls == ["install", "update", "install"]


def test_failure_is_told(machine):
    machine.program("apt-get", 'echo "E: no such luck"; exit 100')
    done, _ = machine.run()
    assert done.returncode == 1
    assert "E: no such luck" in done.stderr and "could not install: removed missing-one" in done.stderr


def test_user_with_sudo(machine):
    machine.program("id", "echo 1000")
    machine.program("sudo", f'echo sudo >>"{machine.calls}"; exec "$@"')
    done, calls = machine.run()
    assert done.returncode == 0, done.stderr
    assert "sudo" in calls and any("missing-one" in call for call in calls)


def test_user_without_sudo_is_told_what_to_type(machine):
    machine.program("id", "echo 1000")
    done, calls = machine.run()
    assert done.returncode == 1 and not calls
    assert "apt-get install --no-install-recommends removed missing-one" in done.stderr


def test_another_system_is_told_what_is_wanted(machine):
    os.unlink(machine.folder / "apt-get")
    done, _ = machine.run()
    assert done.returncode == 1
    assert "Debian 12" in done.stderr and "missing-one" in done.stderr
