main = do
FROM 0 TO 2999:  xNUMBER <- pure NUMBER
  simulate (Say (show x2999))
