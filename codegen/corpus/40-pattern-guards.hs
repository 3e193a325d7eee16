data Shape = Circle Double | Box Double Double

find :: String -> [(String, Shape)] -> Maybe Double
find key table
  | Just (Circle r) <- lookup key table = Just (pi * r * r)
  | Just (Box a b) <- lookup key table, a > 0, b > 0 = Just (a * b)
  | otherwise = Nothing

main = simulate (Say "shapes")
