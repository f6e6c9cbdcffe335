# SPDX-License-Identifier: MIT
"""Kills savers at any moment: no file is ever lost or half written, and nothing is left around.

usage: kills.py SAVE_PROGRAM [--kills N] [--seconds S] [--jobs N]

Each job has a folder of its own, in which a saver saves one file again and again until it is
killed. Ends with status 1 at the first file that isn't whole, or where something is left in the
folder after the next saving.
"""

import argparse
import os
import random
import subprocess
import sys
import tempfile
import threading
import time

SIZES = (0, 100, 70_000, 300_000)


def check_whole(path):
    with open(path, "rb") as file:
        content = file.read()
    if len(content) not in SIZES or content != content[:1] * len(content):
        raise AssertionError(f"{path}: {len(content)} bytes that nobody has saved")


class Campaign:
    def __init__(self, program, kills, seconds):
        self.program = program
        self.left = kills
        self.end = time.monotonic() + seconds
        self.kills = 0
        self.leftovers = 0
        self.failure = None
        self.lock = threading.Lock()

    def next(self):
        with self.lock:
            if self.failure or self.left <= 0 or time.monotonic() > self.end:
                return False
            self.left -= 1
            return True

    def save(self, path, size, *how):
        return [self.program, path, str(size), random.choice("abcdefghij"), *how]

    def kill_one(self, path):
        saver = subprocess.Popen(self.save(path, random.choice(SIZES), "again"))
        time.sleep(random.uniform(0.0, 0.02))
        saver.kill()
        saver.wait()
        check_whole(path)
        others = len(os.listdir(os.path.dirname(path))) - 1
        with self.lock:
            self.kills += 1
            self.leftovers += others

    def clear(self, path):
        subprocess.run(self.save(path, 100), check=True)
        check_whole(path)
        left = os.listdir(os.path.dirname(path))
        if left != [os.path.basename(path)]:
            raise AssertionError(f"left after the next saving: {left}")

    def run(self):
        try:
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "flight.vid")
                self.clear(path)
                while self.next():
                    self.kill_one(path)
                    if random.random() < 0.1:
                        self.clear(path)
                self.clear(path)
        except Exception as error:  # pylint: disable=broad-except
            with self.lock:
                self.failure = error


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--kills", type=int, default=10_000)
    parser.add_argument("--seconds", type=float, default=3600.0)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    campaign = Campaign(options.program, options.kills, options.seconds)
    jobs = [threading.Thread(target=campaign.run) for _ in range(options.jobs)]
    for job in jobs:
        job.start()
    for job in jobs:
        job.join()
    if campaign.failure:
        sys.exit(f"kills: {campaign.failure}")
    print(f"{campaign.kills} kills: nothing lost, {campaign.leftovers} times something was left, "
          "and gone with the next saving")


if __name__ == "__main__":
    main()
