apply2 :: (Int -> Int -> Int) -> Int
apply2 f = f 1 2

test :: [Int]
test =
  [ apply2 (\x y -> x + y)
  , apply2 $ \x y -> x * y
  , apply2 (\_ y -> y)
  , (\(a, b) -> a - b) (3, 4)
  , (\x -> \y -> x) 5 6
  ]

main = simulate (\(Bumper side _) -> Say (show side))
