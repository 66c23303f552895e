"""Names of the variables of an OG1 file: as written, then as other converters do.

Case does not matter.  OG1 1.0 standardizes the fixes, `TIME`, `DEPTH` and `PHASE`;
numbers of dives, displacements, the flight model's speed and the depth-averaged
current are named as by seagliderOG1 and votoutils, or kept from the basestation.
"""

FIXES = ("TIME_GPS", "LATITUDE_GPS", "LONGITUDE_GPS")
STEPS = ("EAST_DISPLACEMENT", "NORTH_DISPLACEMENT")
STEPS_GSM = ("EAST_DISPLACEMENT_GSM", "NORTH_DISPLACEMENT_GSM")
SPEED = ("GLIDER_HORZ_VELO_MODEL", "HORZ_SPEED", "HORZ_SPEED_GSM")
HEADING = ("HEADING", "GLIDER_HEADING", "ENG_HEAD")
NUMBERS = ("DIVE_NUMBER", "DIVE_NUM", "DIVENUM", "DIVE_NUM_CAST")
EAST = ("DAVG_CURR_EAST", "UCUR", "DAC_EAST", "DEPTH_AVG_CURR_EAST")
NORTH = ("DAVG_CURR_NORTH", "VCUR", "DAC_NORTH", "DEPTH_AVG_CURR_NORTH")
QUALITY = ("DAVG_CURR_EAST_QC", "DAVG_CURR_QC", "DEPTH_AVG_CURR_QC")
VARIATION = ("MAGNETIC_VARIATION",)
DEPTH = ("DEPTH", "GLIDER_DEPTH")
DEPTH_MAX = ("DEPTH_MAX",)
GPS1, GPS2, GPSE = 1, 2, 3
UNDER_WATER = (1, 2, 4, 5)  # PHASE: ascent, descent, parking, inflexion
