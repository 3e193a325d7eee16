-- Every way of composing tasks.
data Direction = Ahead | Back

step :: Direction -> Task ()
step Ahead = drive 20
step Back = turn 180

blinking :: Task ()
blinking = forever $ do
  once (Led1 Green)
  wait 1

search :: Double -> Task (Either () ())
search speed = race (task () (spin speed)) (wait 5)
  where
    spin v (Bumper _ _) = Done ()

patrol :: Task ()
patrol = do
  step Ahead
  found <- search 0.5
  case found of
    Left () -> say "found"
    Right () -> step Back
  parallel_ (drive 10) blinking
  patrol

main = simulate patrol
