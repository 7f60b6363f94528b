"""The options that draw one frame of an animation, for scenes that povray renders only as a frame.

Which frames there are says the INI file beside the scene that has its name, as the manual asks of animations
(3.2.1.2): Initial_Frame, Final_Frame, Initial_Clock, Final_Clock. The frame in the middle is drawn.
"""
import re

SETTING = re.compile(r"^\s*(initial|final)_(frame|clock)\s*=\s*([-+.\w]+)\s*$", re.IGNORECASE | re.MULTILINE)
SWITCHES = {"initial frame": "+KFI", "final frame": "+KFF", "initial clock": "+KI", "final clock": "+KF"}


def frame_options(scene_path):
    """() if no INI file beside the scene says that it is an animation."""
    ini = scene_path.with_suffix(".ini")
    if not ini.is_file():
        return ()
    text = ini.read_bytes().decode("latin-1").replace("\r", "")
    settings = {f"{end} {what}".lower(): value for end, what, value in SETTING.findall(text)}
    try:
        first, last = int(settings["initial frame"]), int(settings["final frame"])
    except (KeyError, ValueError):
        return ()
    middle = (first + last) // 2
    return (*(switch + settings[name] for name, switch in SWITCHES.items() if name in settings),
            f"+SF{middle}", f"+EF{middle}")
