"""Problem files of gears and cams, for tests of exports."""

ROLLER_CAM = """kind = "cam"
length_unit = "mm"
[follower]
type = "translating-roller"
{more}
[[motion]]
law = "cycloidal"
over_deg = 120
rise = 25
[[motion]]
law = "dwell"
over_deg = 60
[[motion]]
law = "cycloidal"
over_deg = 120
rise = -25
[[motion]]
law = "dwell"
over_deg = 60
[mechanism]
base_radius = 40
offset = 12
roller_radius = 9
"""


def gear(teeth, shift=0.0, module=5, more=""):
    return (f'kind = "gear"\nlength_unit = "mm"\nmechanism = {{teeth = {teeth}, module = {module}, '
            f"profile_shift = {shift}{more}}}\n")
