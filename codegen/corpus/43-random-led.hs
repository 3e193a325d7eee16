data Light = Light Int

light :: StdGen -> Led1
light g = Led1 (colors !! i)
  where
    (i, _) = randomR (0, 3) g
    colors = [Black, Green, Orange, Red]

main :: IO ()
main = simulate light
