#!/usr/bin/python3
"""Run one command and write what it cost: usage measure_child.py ORDER.json (see processes.py).

A separate small process, because the kernel counts the memory of the process that starts a program into the
program's own peak: started from a Python that holds numpy, a sphere would seem to need 40 MB.
It imports nothing large for the same reason.
"""
import json
import os
import resource
import signal
import sys
import time


def main():
    with open(sys.argv[1]) as file:
        order = json.load(file)
    started = time.monotonic()
    child = os.fork()
    if child == 0:
        try:
            become(order)
        except OSError as error:
            os.write(2, f"cannot start {order['command'][0]}: {error}\n".encode())
        os._exit(127)

    # The wall clock limit catches what waits instead of computing; computing is bounded by RLIMIT_CPU.
    timed_out = []

    def on_alarm(_signal, _frame):
        timed_out.append(True)
        os.killpg(child, signal.SIGKILL)

    signal.signal(signal.SIGALRM, on_alarm)
    signal.setitimer(signal.ITIMER_REAL, order["wall_limit"])
    _, status, usage = os.wait4(child, 0)
    signal.setitimer(signal.ITIMER_REAL, 0)
    wall = time.monotonic() - started

    code = os.waitstatus_to_exitcode(status)
    cpu = usage.ru_utime + usage.ru_stime
    if code == -signal.SIGXCPU or (code == -signal.SIGKILL and cpu >= order["cpu_limit"] - 1):
        timed_out.append(True)
    result = {"code": code, "cpu": cpu, "wall": wall, "peak_kb": usage.ru_maxrss,
              "timed_out": bool(timed_out)}
    with open(order["result"], "w") as file:
        json.dump(result, file)


def become(order):
    os.setpgid(0, 0)
    if order["nice"]:
        os.nice(order["nice"])
    resource.setrlimit(resource.RLIMIT_CPU, (order["cpu_limit"], order["cpu_limit"] + 2))
    if order["memory_limit"]:
        resource.setrlimit(resource.RLIMIT_AS, (order["memory_limit"], order["memory_limit"]))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    for descriptor, path in ((1, order["stdout"]), (2, order["stderr"])):
        opened = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o644)
        os.dup2(opened, descriptor)
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.chdir(order["folder"])
    os.execvpe(order["command"][0], order["command"], {**os.environ, **order["environment"]})


main()
