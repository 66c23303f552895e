#!/bin/sh
# The page of a Seaglider after each dive, by basestation3's hook `.post_dive`.
#
#     cp basestation3_post_dive.sh ~sg171/.post_dive; chmod +x ~sg171/.post_dive
#
# basestation3 runs an executable file of that name in the mission directory when the files of a
# dive are made, and ends it after 120 s (--post_dive_timeout).  Its newer versions give two
# arguments, the folder of the basestation and the mission directory, older ones none; what is
# said here goes into the log.  All files of the mission are read after each dive.
#
# The page is MISSION/clpt/replay.html.  CLPT says where the command is, if not on the path.

mission=${2:-$(dirname "$0")}
exec "${CLPT:-clpt}" watch "$mission" --patience 0 --out "$mission/clpt" >/dev/null
