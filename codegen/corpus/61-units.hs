data Wheel2 = Wheel2 { radius, width :: Meters, turns :: Int }

distance :: Wheel2 -> Meters
distance w = 2 * pi * radius w * fromIntegral (turns w)

newtype Speed = Speed Double deriving Show
newtype Box a = Box { unBox :: a -> Maybe (a, [a]) }

main = simulate (Say (show (Speed 3)))
