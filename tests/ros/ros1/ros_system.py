# SPDX-License-Identifier: Apache-2.0
"""A ROS 1 system for one test: a master on a free port, and processes that end with it."""

import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import time

SKIPPED = 77  # ctest's SKIP_RETURN_CODE


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class RosSystem:
    """Starts a roscore; `package` is the folder with the built nodes."""

    def __init__(self, package):
        self.package = pathlib.Path(package)
        self.folder = tempfile.TemporaryDirectory(prefix="fairway-ros-")
        self.processes = []
        os.environ.update(
            ROS_MASTER_URI=f"http://127.0.0.1:{free_port()}", ROS_IP="127.0.0.1",
            ROS_HOME=self.folder.name, ROS_LOG_DIR=self.folder.name + "/log",
            ROS_PACKAGE_PATH=str(self.package.parent), PYTHONUNBUFFERED="1")
        port = os.environ["ROS_MASTER_URI"].rsplit(":", 1)[1]
        self.start("roscore", "-p", port, name="roscore")
        self.wait_for(self.master_answers, 30, "the master")

    def master_answers(self):
        import rosgraph
        return rosgraph.is_master_online()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def start(self, *command, name=None, environment=None):
        """Runs a program; its output goes to a file that is shown when the test fails."""
        name = name or pathlib.Path(command[0]).name
        log = open(self.path(f"{name}-{len(self.processes)}.txt"), "w+", encoding="utf-8")
        process = subprocess.Popen([str(part) for part in command], stdout=log,
                                   stderr=subprocess.STDOUT, start_new_session=True,
                                   env={**os.environ, **(environment or {})})
        process.log, process.name = log, name
        self.processes.append(process)
        return process

    def node(self, program, *arguments, name=None, namespace=None):
        environment = {"ROS_NAMESPACE": namespace} if namespace else {}
        return self.start(self.package / program, *arguments, name=name or program,
                          environment=environment)

    @staticmethod
    def wait_for(condition, seconds, what):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            value = condition()
            if value:
                return value
            time.sleep(0.02)
        raise AssertionError(f"waited {seconds} s for {what}")

    @staticmethod
    def end(process, how=signal.SIGINT, seconds=15):
        if process.poll() is None:
            process.send_signal(how)
        try:
            return process.wait(seconds)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            raise AssertionError(f"{process.name} did not end in {seconds} s") from None

    def close(self, show):
        for process in reversed(self.processes):
            if process.poll() is None:
                process.terminate()
                try:
                    process.wait(10)
                except subprocess.TimeoutExpired:
                    process.kill()
                    process.wait()
            if show:
                process.log.seek(0)
                print(f"--- {process.name}\n{process.log.read()[-4000:]}")
            process.log.close()
        self.folder.cleanup()
