main = drive 50
       turn 90
