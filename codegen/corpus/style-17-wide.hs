-- Long lines and deep trees, as they grow over time.
type Reading = (Double, Double, Double)
type Table k v = [(k, v)]

weights :: Table String (Double -> Double -> Double)
weights = [("sum", (+)), ("product", (*)), ("larger", max), ("smaller", min), ("first", const), ("second", flip const), ("mean", \a b -> (a + b) / 2)]

decide :: Double -> Double -> Double -> Bool -> Bool -> Velocity
decide left middle right pressed hole = if pressed || hole then Velocity (-0.1) (if left > right then 0.5 else -0.5) else if left < 0.3 && middle < 0.3 && right < 0.3 then Velocity 0 1 else if left < right then Velocity 0.2 (-0.3) else Velocity 0.2 0.3

smooth :: [Reading] -> [Reading]
smooth rs@((a, b, c) : (d, e, f) : _) = ((a + d) / 2, (b + e) / 2, (c + f) / 2) : smooth (drop 1 rs)
smooth rs = rs

report :: Reading -> String
report (a, b, c) = "left " ++ show (fromIntegral (round (a * 100) :: Int) / 100 :: Double) ++ ", middle " ++ show b ++ ", right " ++ show c ++ (if a + b + c > 3 then ", wide" else if a + b + c < 1 then ", narrow" else "")

chain :: Double -> Double
chain x = ((((((((x + 1) * 2) - 3) / 4) ** 2) + 5) * 6) - 7) / 8 + sin (cos (tan (exp (log (sqrt (abs (negate x)))))))

logic :: Bool -> Bool -> Bool -> Bool
logic a b c = a && b || not a && c || (a || b) && not (b && c) && (a == b) /= (b == c)

main = simulate (\(Velocity _ w) -> decide w w w False False)
