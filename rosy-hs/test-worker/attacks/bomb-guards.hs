main = simulate f

f :: Velocity -> Say
f (Velocity a b)
FROM 0 TO 1499:  | a > NUMBER, b < NUMBER, Just c <- Just (a * NUMBER), c > b = Say "NUMBER"
  | otherwise = Say "none"
