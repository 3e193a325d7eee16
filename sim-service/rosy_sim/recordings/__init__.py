"""
Recordings of runs on real robots: MCAP files, their folder, and their replay into a program.
"""
