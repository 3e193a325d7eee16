go :: Double -> Task ()
go m = task (\p -> Memory (positionToVec p)) $ \(Memory s) p ->
  if magnitudeVec (positionToVec p `subVec` s) > m
    then Right (Done ())
    else Left (Velocity 0.2 0)

main = simulate $ go 1 >> go 2 >> say "there"
