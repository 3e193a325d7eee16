-- task whose init is a function of sensors; result through do; recursion with accumulator
data Leg = Leg Double deriving Show

start :: Position -> Orientation -> Memory (Double, Orientation)
start (Position x _) o = Memory (x, o)

ahead :: Position -> Memory (Double, Orientation) -> Either Velocity (Done Double)
ahead (Position x _) (Memory (x0, _))
  | x - x0 < 0.5 = Left (Velocity 0.25 0)
  | otherwise = Right (Done (x - x0))

leg :: Task Double
leg = task start ahead

legs :: Int -> [Double] -> Task [Double]
legs 0 ds = return (reverse ds)
legs n ds = do
  d <- leg
  legs (n - 1) (d : ds)

main = simulate $ do
  ds <- legs 2 []
  ds' <- replicateM 1 leg
  say (show (map (\d -> fromIntegral (round (d * 10)) / 10) (ds ++ ds')))
