"""Where the parts meet: the numbers that the program hard-codes too, and the plates that others stand on."""

HALF_LENGTH, HALF_WIDTH = 3.75, 1.78
DECK, BELLY = 1.60, 0.48
TRACK_X, TRACK_W, LINK = 1.38, 0.62, 0.08
WHEEL_R, WHEEL_W, WHEEL_Y = 0.36, 0.50, 0.44
WHEEL_Z = [2.40, 1.60, 0.80, 0.0, -0.80, -1.60, -2.40]
TURRET = (0.0, 1.60, 0.25)  # in the tank
TRUNNION = (0.0, 0.42, 1.25)  # in the turret
CUPOLA = (-0.55, 0.95, -0.35)  # in the turret: the machine gun's pivot
MG_OFFSET = (0.0, 0.0, 0.25)  # p_pivot = p_mesh + MG_OFFSET, at rest
MG_TRUNNION = (0.0, 0.27, 0.31)  # from the machine gun's pivot: about this it pitches
BOARD = (0.25, 0.062)  # half the size of the boards with the tank's number
GLACIS = (1.1156 - 1.60) / (3.62 - 1.85)  # rise of the upper front plate per metre of z


def yz(*points):
    """A side view given as (z, y) turned into the SIDE frame's (y, z)."""
    return [(y, z) for z, y in points]


def glacis(z):
    return DECK + (z - 1.85) * GLACIS


def trunnion_in_machine_gun():
    return tuple(a - b for a, b in zip(MG_TRUNNION, MG_OFFSET))
