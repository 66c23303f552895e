"""Names of the variables of an OG1 file, the first of each as written."""

FIXES = ("TIME_GPS", "LATITUDE_GPS", "LONGITUDE_GPS")
STEPS = ("EAST_DISPLACEMENT", "NORTH_DISPLACEMENT")
NUMBERS = ("DIVE_NUMBER", "DIVE_NUM", "divenum", "dive_num_cast")
EAST = ("DAVG_CURR_EAST", "UCUR", "DAC_EAST", "depth_avg_curr_east")
NORTH = ("DAVG_CURR_NORTH", "VCUR", "DAC_NORTH", "depth_avg_curr_north")
QUALITY = ("DAVG_CURR_EAST_QC", "DAVG_CURR_QC")
VARIATION = ("MAGNETIC_VARIATION", "magnetic_variation")
GPS1, GPS2, GPSE = 1, 2, 3
