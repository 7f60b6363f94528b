"""What the tests that run the installed povray beside durer have in common."""
import concurrent.futures
import shutil
import sys
from pathlib import Path

# povray sleeps most of its run, so more run at a time than there are processors.
AT_A_TIME = 6


def programs():
    """The paths of povray and of durer, and the part of a case's name: a test's arguments."""
    povray = shutil.which("povray")
    if not povray:
        sys.exit("povray is not installed: nothing to compare with")
    return povray, str(Path(sys.argv[1]).resolve()), sys.argv[2] if len(sys.argv) > 2 else ""


def exit_code(cases, check, title, what):
    """Runs check(case), which tells what is wrong (empty: nothing), for all cases and prints the wrong
    ones. 0 if there are none; 1 otherwise, and where there are no cases."""
    with concurrent.futures.ThreadPoolExecutor(AT_A_TIME) as pool:
        answers = list(pool.map(check, cases))
    bad = [(case, answer) for case, answer in zip(cases, answers) if answer]
    for case, answer in bad:
        print(f"{title(case)}: {answer}")
    print(f"{len(cases) - len(bad)} of {len(cases)} {what}")
    return 1 if bad or not cases else 0
