measure :: Task Double
measure = do
  start <- once here
  wait 2
  end <- once here
  return (magnitudeVec (subVec end start))
  where here p = positionToVec p

main :: IO ()
main = simulate $ do
  d <- measure
  say ("I went " ++ show d ++ " metres")
