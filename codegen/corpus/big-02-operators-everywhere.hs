-- A little language of movements, in a style that loves operators.

infixr 5 :>
infixl 4 |>, <|
infixr 3 &&&

data Path = End | Step :> Path

data Step
  = Ahead Double
  | Around Double
  | Pause Seconds
  | Loud Sound

type Plan = [Step]

(|>) :: a -> (a -> b) -> b
x |> f = f x

(<|) :: (a -> b) -> a -> b
f <| x = f x

(&&&) :: (a -> Bool) -> (a -> Bool) -> a -> Bool
(p &&& q) x = p x && q x

toList :: Path -> Plan
toList End = []
toList (s :> rest) = s : toList rest

fromList :: Plan -> Path
fromList = foldr (:>) End

reverseStep :: Step -> Step
reverseStep (Ahead d) = Ahead (-d)
reverseStep (Around a) = Around $ -a
reverseStep s = s

undo :: Path -> Path
undo = fromList . map reverseStep . reverse . toList

isMove, isLong, isTurn :: Step -> Bool
isMove (Ahead _) = True
isMove _ = False
isLong (Ahead d) = abs d >= 1
isLong (Around a) = abs a > pi / 2
isLong _ = False
isTurn = not . isMove

longMoves :: Path -> Int
longMoves p = toList p |> filter (isMove &&& isLong) |> length

lengthOf :: Path -> Double
lengthOf = sum . map size . toList
  where
    size (Ahead d) | d >= 0 = d
                   | otherwise = negate d
    size _ = 0

square :: Double -> Path
square a = fromList . concat . replicate 4 $ [Ahead a, Around (pi / 2)]

spiral :: Path
spiral = go 1 End
  where
    go :: Int -> Path -> Path
    go n p
      | n > 12 = p
      | even n, n `mod` 4 == 0 = Loud ButtonSound :> go (n + 1) p
      | even n = Around (pi / 2) :> go (n + 1) p
      | otherwise = Ahead (fromIntegral n * 0.1 ** 1.5 - 0.01) :> go (n + 1) p

run :: Path -> Task ()
run End = return ()
run (s :> rest) = one s >> run rest
  where
    one (Ahead d) = move d
    one (Around a) = turn' a
    one (Pause t) = wait t
    one (Loud s') = once s'

move :: Double -> Task ()
move d = task start $ \(Memory p) q ->
  let gone = magnitudeVec (positionToVec q `subVec` positionToVec p)
   in if gone >= abs d then Right (Done ()) else Left <| Velocity (signum d * 0.2) 0
  where
    start :: Position -> Memory Position
    start = Memory

turn' :: Double -> Task ()
turn' a = task (\o -> Memory (o + a' :: Orientation)) check
  where
    a' = radians a
    radians = Orientation
    check (Memory goal) o
      | abs (normOrientation $ goal - o) < 0.05 = Right <| Done ()
      | otherwise = Left . Velocity 0 $ if a > 0 then 0.5 else -0.5

main :: IO ()
main = simulate $ do
  run <| square 0.5
  say $ "walked " ++ show (lengthOf $ square 0.5) ++ " m, " ++ show (longMoves spiral) ++ " long"
  run spiral
  wait 2 >> run (undo spiral) >>= \() -> say "home"
