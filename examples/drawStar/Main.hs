-- The pen draws where the robot drives: a star with five points.
drawStar :: Task ()
drawStar = do
  penColor BlueInk
  penWidth 5
  penDown
  replicateM_ 5 $ do
    drive 100
    turn 144
  penUp
  say "a star"

main :: IO ()
main = simulate drawStar
