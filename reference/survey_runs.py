"""The two runs of povray that show whether a scene's picture depends on povray's threads and blocks."""
import grades
import renderers

SIZE = ("+W160", "+H120", "-A")
ONE_THREAD = (*SIZE, "+WT1", "+BS32")
TWO_THREADS = (*SIZE, "+WT2", "+BS8")


def is_random(scene, one, limit):
    """povray disagrees with itself: the picture `one` of ONE_THREAD and that of TWO_THREADS are not `exact`."""
    if one.path is None:
        return False
    two = renderers.povray(scene, TWO_THREADS, 2 * limit)
    if two.path is None:
        return True
    return grades.compare_pixels(grades.read_pixels(one.path),
                                 grades.read_pixels(two.path)).grade != "exact"
