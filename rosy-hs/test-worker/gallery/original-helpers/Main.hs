main = simulate report

report :: BumperRight -> Say
report b = Say (show (swap (bumperRightStatus b, average [1, 2, 3]), thr4 (1, 2, roundFloating 2.6, 4)))
