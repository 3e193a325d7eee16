{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE MultiWayIf #-}

-- Guards wherever they may stand.
data Zone = Near | Middle | Far

zone :: Double -> Zone
zone d
  | d < near = Near
  | d < far, d >= near = Middle
  | otherwise = Far
  where
    near = 0.5
    far | wide = 3
        | otherwise = 2
      where wide = True

name :: Zone -> String
name = \case
  Near -> "near"
  Middle | lucky -> "lucky middle"
         | otherwise -> "middle"
    where lucky = 1 > (2 :: Int)
  Far -> "far"

speed :: Double -> Double
speed d = if | d < 0.2 -> 0
             | d < 1, let e = d * d, e > 0.1 -> e / 2
             | otherwise -> 0.5

lookups :: [(Int, String)] -> Int -> String
lookups table n
  | Just s <- lookup n table, not (null s) = s
  | Just _ <- lookup n table
  , n > 3
  = "empty"
  | let m = n - 1, Just s <- lookup m table = s
lookups _ _ = "none"

bounded :: Int -> Int
bounded n = let m | n > 10 = 10
                  | n < 0 = 0
                  | True = n
            in m

main = simulate (\(Position x _) -> Velocity (speed x) 0)
