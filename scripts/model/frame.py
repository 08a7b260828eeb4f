"""Where the parts meet: the numbers that the program hard-codes too."""
HALF_LENGTH, HALF_WIDTH = 3.75, 1.78
DECK, BELLY = 1.60, 0.48
TRACK_X, TRACK_W, LINK = 1.38, 0.62, 0.08
WHEEL_R, WHEEL_W, WHEEL_Y = 0.36, 0.50, 0.44
WHEEL_Z = [2.40, 1.60, 0.80, 0.0, -0.80, -1.60, -2.40]
TURRET = (0.0, 1.60, 0.25)  # in the tank
TRUNNION = (0.0, 0.42, 1.25)  # in the turret
CUPOLA = (-0.55, 0.95, -0.35)  # in the turret: the machine gun's pivot
MG_OFFSET = (0.0, 0.0, 0.25)  # p_pivot = p_mesh + MG_OFFSET
